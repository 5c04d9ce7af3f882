// Holds the springy nose against a step-by-step integration of its springs.
#include "common/physics/cushion_stronge.h"

#include "tests/common/physics/lone_ball.h"

namespace billiards::physics {
namespace {

constexpr double kLean = 0.27;
const Vec3 kNormal{std::sqrt(1 - kLean * kLean), 0, kLean};

/// Along the cushion, in the units of the model: slip over (7/2) mu c, time over the normal
/// spring's. The spring across is stretched by the slip, and slips where it pulls harder than
/// friction holds.
double integrated_slip(double slip, double e) {
    constexpr int kSteps = 100'000;
    const double way_in = base::kPi / 2;
    const double step = way_in * (1 + e) / kSteps;
    double force = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double time = step * (i + 0.5);
        const double hold = time < way_in ? std::sin(time) : std::sin(way_in + (time - way_in) / e);
        slip -= force * step / 2;
        force = std::clamp(force + 1.8 * 1.8 * slip * step, -hold, hold);
        slip -= force * step / 2;
    }
    return slip;
}

/// A ball that comes straight at a closing speed of 1 along the normal, and slips along the
/// cushion.
Body slipping(double slip_mps) {
    return lone_ball({1 / kNormal.x, slip_mps, 0}, {0, -kLean / kNormal.x / kRadius_m, 0});
}

TEST(StrongeCushion, SlipsAndSticksAsItsSpringsDo) {
    const double mu = 0.2;
    for (const double e : {0.3, 0.5, 0.6, 0.85, 1.0}) {
        for (const double share : {0.01, 0.1, 0.25, 0.31, 0.5, 0.9, 1.1, 1.4, 1.6, 3.0}) {
            const double unit = 3.5 * mu;
            const Body after =
                bounced(with_cushion(CushionModel::Stronge, e, mu), slipping(share * unit), kLean);
            const Vec3 rim = kRadius_m * glm::cross(after.state.spin_radps, kNormal);
            const double left = (after.state.velocity_mps.y + rim.y) / unit;
            EXPECT_NEAR(left, integrated_slip(share, e), 1e-4) << "e " << e << ", slip " << share;
        }
    }
}

TEST(StrongeCushion, GivesBackTheNormalSpeedAndLeavesTheVerticalToTheSlate) {
    for (const double e : {0.0, 0.5, 0.85, 1.0}) {
        const Parameters smooth = with_cushion(CushionModel::Stronge, e, 0.0);
        const Body after = bounced(smooth, lone_ball({2, 1, 0}, {30, -20, 50}), kLean);
        EXPECT_NEAR(after.state.velocity_mps.x, 2 - (1 + e) * 2 * (1 - kLean * kLean), 1e-14);
        EXPECT_EQ(after.state.velocity_mps.y, 1.0);
        EXPECT_EQ(after.state.velocity_mps.z, 0.0);
        EXPECT_EQ(after.state.spin_radps, (Vec3{30, -20, 50}));
    }
}

TEST(StrongeCushion, ABallInTheAirKeepsWhatTheNoseGivesIt) {
    Body ball = lone_ball({2, 1, 0.3}, {30, -20, 50});
    ball.is_on_slate = false;
    const Body after = bounced(with_cushion(CushionModel::Stronge, 0.85, 0.2), ball, kLean);
    EXPECT_NEAR(glm::dot(after.state.velocity_mps, kNormal),
                -0.85 * glm::dot(ball.state.velocity_mps, kNormal), 1e-14);
    EXPECT_LT(after.state.velocity_mps.z, 0.3);
}

TEST(StrongeCushion, AFastSlipTakesAllThatFrictionHas) {
    const Body ball = slipping(5.0);
    const Body after = bounced(with_cushion(CushionModel::Stronge, 0.85, 0.2), ball, kLean);
    EXPECT_NEAR(after.state.velocity_mps.y, 5.0 - 0.2 * 1.85, 1e-14);
}

TEST(StrongeCushion, NeverAddsEnergyAndMirrorsAMirroredBallBitForBit) {
    base::Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Parameters parameters =
            with_cushion(CushionModel::Stronge, random.uniform(0.0, 1.0), random.uniform(0.0, 1.0));
        const Body ball = random_ball(random);
        const Body after = bounced(parameters, ball);
        EXPECT_LE(energy_of(after), energy_of(ball) + 1e-13);
        Body mirrored = ball;
        mirrored.state.velocity_mps *= Vec3{1, -1, 1};
        mirrored.state.spin_radps *= Vec3{-1, 1, -1};
        const Body other = bounced(parameters, mirrored);
        EXPECT_EQ(other.state.velocity_mps, after.state.velocity_mps * Vec3(1, -1, 1));
        EXPECT_EQ(other.state.spin_radps, after.state.spin_radps * Vec3(-1, 1, -1));
    }
}

}  // namespace
}  // namespace billiards::physics
