// Holds the collision models against closed forms and published results.
#include "common/physics/collide_cushion.h"
#include "common/physics/motion.h"
#include "tests/common/physics/still_life.h"

#include <rapidcheck/gtest.h>

namespace billiards::physics {
namespace {

Parameters elastic() {
    Parameters parameters;
    parameters.ball_ball = BallBallModel::Elastic;
    return parameters;
}

/// Ball 0 comes along +x at `speed` and meets ball 1 so that the line of centres makes `cut_rad`
/// with +x. The velocities right after.
struct AfterCut {
    Vec3 cue_velocity;
    Vec3 cue_spin;
    Vec3 object_velocity;
};

AfterCut after_cut(const Parameters& parameters, double speed, double cut_rad, Vec3 spin) {
    const Vec2 normal{base::cosine(cut_rad), base::sine(cut_rad)};
    const auto record =
        solved(model::open_table(), parameters,
               {ball_at(0, -2 * kRadius_m * normal, {speed, 0}, spin), ball_at(1, {0, 0})});
    const auto& cue = track_of(record, 0).segments.front();
    return {cue.velocity_mps, cue.spin_radps, track_of(record, 1).segments.front().velocity_mps};
}

TEST(BallCollision, ElasticBallsPartAtNinetyDegrees) {
    for (const double cut : {0.1, 0.5, 1.0, 1.5}) {
        const AfterCut after = after_cut(elastic(), 3.0, cut, {});
        EXPECT_NEAR(glm::dot(after.cue_velocity, after.object_velocity), 0.0, 1e-14);
        EXPECT_NEAR(speed_of(after.object_velocity), 3.0 * std::cos(cut), 1e-14);
    }
}

TEST(BallCollision, StopShotKeepsHalfOfWhatRestitutionLoses) {
    const Parameters parameters = realistic_parameters();
    const double e = parameters.ball_ball_restitution;
    const AfterCut after = after_cut(parameters, 2.0, 0.0, {});
    EXPECT_NEAR(after.cue_velocity.x, 2.0 * (1 - e) / 2, 1e-14);
    EXPECT_NEAR(after.object_velocity.x, 2.0 * (1 + e) / 2, 1e-14);
}

TEST(BallCollision, UnequalMassesFollowMomentumAndRestitution) {
    const double m1 = 0.3;
    const double m2 = 0.1;
    BallStart heavy = ball_at(0, {-2 * kRadius_m, 0}, {2, 0});
    BallStart light = ball_at(1, {0, 0});
    heavy.spec.mass_kg = m1;
    light.spec.mass_kg = m2;
    const double e = Parameters{}.ball_ball_restitution;
    const auto record = solved(model::open_table(), {}, {heavy, light});
    EXPECT_NEAR(track_of(record, 0).segments[0].velocity_mps.x, 2 * (m1 - e * m2) / (m1 + m2),
                1e-14);
    EXPECT_NEAR(track_of(record, 1).segments[0].velocity_mps.x, 2 * (m1 + e * m1) / (m1 + m2),
                1e-14);
}

double throw_deg(double speed, double cut_rad, Vec3 spin) {
    const Vec3 v = after_cut(realistic_parameters(), speed, cut_rad, spin).object_velocity;
    return base::degrees(cut_rad - std::atan2(v.y, v.x));
}

TEST(BallCollision, ThrowIsAFewDegreesAndFallsWithSpeed) {
    const double slow = throw_deg(0.5, base::radians(30), {});
    const double fast = throw_deg(4.0, base::radians(30), {});
    EXPECT_GT(slow, 3.0);
    EXPECT_LT(slow, 6.0);
    EXPECT_GT(fast, 0.5);
    EXPECT_LT(fast, slow);
}

TEST(BallCollision, ThrowVanishesAtGearingEnglish) {
    // Side spin R w_z = v sin(cut): the contact points do not slip.
    const double cut = base::radians(30);
    const double gearing = 2.0 * std::sin(cut) / kRadius_m;
    EXPECT_NEAR(throw_deg(2.0, cut, {0, 0, gearing}), 0.0, 1e-9);
    EXPECT_LT(throw_deg(2.0, cut, {0, 0, 2 * gearing}), 0.0) << "more than gearing throws back";
}

TEST(BallCollision, ThirtyDegreeRulePeaksAt33Point749Degrees) {
    // Ideal balls, the cue ball rolling: its final deflection over all cuts (Alciatore TP 3.3).
    double peak = 0.0;
    for (double cut = 0.3; cut < 0.9; cut += 0.0005) {
        const Vec2 velocity{2.0, 0.0};
        const AfterCut after = after_cut(elastic(), 2.0, cut, rolling_spin(velocity));
        const model::BallState cue{.velocity_mps = after.cue_velocity,
                                   .spin_radps = after.cue_spin};
        const Vec3 rolling = cue.velocity_mps - 2.0 / 7.0 * slip_mps(cue, kRadius_m);
        peak = std::max(peak, base::degrees(std::abs(std::atan2(rolling.y, rolling.x))));
    }
    EXPECT_NEAR(peak, 33.749, 0.001);
}

double energy_of(const timeline::ShotRecord& record) {
    double total = 0.0;
    for (const auto& track : record.timeline.tracks) {
        total += energy_j({}, {}, timeline::evaluate(track, 0.0));
    }
    return total;
}

RC_GTEST_PROP(BallCollision, LosesEnergyAndKeepsMomentum, ()) {
    base::Random random(*rc::gen::arbitrary<std::uint64_t>());
    const auto vector = [&](double reach) {
        return Vec2{random.uniform(-reach, reach), random.uniform(-reach, reach)};
    };
    const double angle = random.uniform(0, 6.28);
    BallStart a = ball_at(0, {0, 0}, vector(5), {vector(200), random.uniform(-200, 200)});
    BallStart b = ball_at(1, 2 * kRadius_m * Vec2{base::cosine(angle), base::sine(angle)},
                          vector(5), {vector(200), random.uniform(-200, 200)});
    const auto record = simulate(model::open_table(), {}, std::vector{a, b});
    RC_ASSERT(record.ok());
    double before = 0.0;
    for (const BallStart& ball : {a, b}) {
        before += energy_j({}, {},
                           {.position_m = ball.position_m,
                            .velocity_mps = ball.velocity_mps,
                            .spin_radps = ball.spin_radps});
    }
    RC_ASSERT(energy_of(*record) <= before + 1e-13);
    const Vec3 momentum = track_of(*record, 0).segments[0].velocity_mps +
                          track_of(*record, 1).segments[0].velocity_mps;
    RC_ASSERT(speed_of(momentum - a.velocity_mps - b.velocity_mps) < 1e-13);
}

struct Rebound {
    Vec3 velocity;
    Vec3 spin;
};

/// A ball that meets a cushion lying at x = 0.5 with this velocity and spin.
Rebound rebound(const Parameters& parameters, Vec2 velocity, Vec3 spin) {
    model::TableSpec table;
    table.cushions = {{{0.5, -9}, {0.5, 9}}};
    table.nose_height_m = 0.635 * 2 * kRadius_m;
    const auto record =
        solved(table, parameters, {ball_at(1, {0.5 - kRadius_m, 0}, velocity, spin)});
    const auto& after = track_of(record, 1).segments.front();
    return {after.velocity_mps, after.spin_radps};
}

TEST(CushionCollision, MirrorReflectsAndScales) {
    Parameters parameters;
    parameters.cushion = CushionModel::Mirror;
    parameters.cushion_restitution = 0.7;
    const Rebound after = rebound(parameters, {2, 1}, {});
    EXPECT_NEAR(after.velocity.x, -1.4, 1e-14);
    EXPECT_NEAR(after.velocity.y, 0.7, 1e-14);
}

TEST(CushionCollision, HanFollowsItsFormulasForASlidingBall) {
    const Parameters parameters = realistic_parameters();
    const double v = 2.0;
    const double sine = 0.27;
    const double cosine = std::sqrt(1 - sine * sine);
    // s_x = v sin is within the grip: P_x = (2/7) m s_x.
    const double p_x = std::min(2.0 / 7.0 * v * sine, 0.2 * 1.85 * v * cosine);
    const Rebound after = rebound(parameters, {v, 0}, {});
    EXPECT_NEAR(after.velocity.x, v - p_x * sine - 1.85 * v * cosine * cosine, 1e-13);
    EXPECT_NEAR(after.spin.y, -2.5 * p_x / kRadius_m, 1e-11);
    EXPECT_EQ(after.velocity.z, 0.0);
}

TEST(CushionCollision, RunningEnglishWidensTheRebound) {
    const Parameters parameters = realistic_parameters();
    const Rebound plain = rebound(parameters, {2, 1}, {});
    // Spin that drives the contact point along +y off a cushion at +x: clockwise from above.
    const Rebound running = rebound(parameters, {2, 1}, {0, 0, -80});
    const Rebound reverse = rebound(parameters, {2, 1}, {0, 0, 80});
    EXPECT_GT(running.velocity.y, plain.velocity.y);
    EXPECT_LT(reverse.velocity.y, plain.velocity.y);
}

TEST(CushionCollision, NeverAddsEnergy) {
    base::Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 velocity{random.uniform(0.01, 8), random.uniform(-8, 8), 0};
        const Vec3 spin{random.uniform(-200, 200), random.uniform(-200, 200),
                        random.uniform(-200, 200)};
        Body ball{
            .spec = {},
            .state = {
                .position_m = {0, 0, kRadius_m}, .velocity_mps = velocity, .spin_radps = spin}};
        const double before = energy_j({}, {}, ball.state);
        const Kick kick =
            cushion_kick({}, ball, {.into = {1, 0}, .lean_sine = 0.27, .closing_mps = velocity.x});
        ball.state.velocity_mps += kick.velocity_mps;
        ball.state.spin_radps += kick.spin_radps;
        EXPECT_LE(energy_j({}, {}, ball.state), before + 1e-13);
        EXPECT_LT(ball.state.velocity_mps.x, 0.0);
    }
}

}  // namespace
}  // namespace billiards::physics
