// Holds sliding, rolling, spinning and flight against their closed forms.
#include "common/physics/motion.h"

#include "tests/common/physics/still_life.h"

namespace billiards::physics {
namespace {

const Parameters kRealistic = realistic_parameters();

TEST(Motion, SlidesUntilNaturalRoll) {
    const double v = 2.0;
    const double mu_g = kRealistic.sliding_friction * kRealistic.gravity_mps2;
    const auto record = solved(model::open_table(), kRealistic, {ball_at(1, {0, 0}, {v, 0})});
    const auto& rolling = track_of(record, 1).segments.at(1);
    EXPECT_EQ(rolling.motion, Motion::Rolling);
    EXPECT_NEAR(rolling.start_s, 2 * v / (7 * mu_g), 1e-14);
    EXPECT_NEAR(rolling.velocity_mps.x, 5.0 / 7.0 * v, 1e-14);
    EXPECT_NEAR(rolling.position_m.x, 12 * v * v / (49 * mu_g), 1e-14);
    EXPECT_NEAR(rolling.spin_radps.y, rolling.velocity_mps.x / kRadius_m, 1e-12);
}

TEST(Motion, RollsAsFarAsRollingFrictionLets) {
    const double v = 1.4;
    const double mu_g = kRealistic.rolling_friction * kRealistic.gravity_mps2;
    const auto record =
        solved(model::open_table(), kRealistic, {ball_at(1, {0, 0}, {0, v}, rolling_spin({0, v}))});
    EXPECT_NEAR(record.duration_s, v / mu_g, 1e-12);
    EXPECT_NEAR(record.final_layout.balls[0].position_m.y, v * v / (2 * mu_g), 1e-12);
    EXPECT_EQ(track_of(record, 1).segments.back().motion, Motion::Resting);
}

TEST(Motion, CurvesWhileSpinIsAcrossTheVelocity) {
    // A masse-like spin about the direction of travel: the slip has a part across it.
    const auto record =
        solved(model::open_table(), kRealistic, {ball_at(1, {0, 0}, {2, 0}, {30, 0, 0})});
    const Vec3 slip = slip_mps({.velocity_mps = {2, 0, 0}, .spin_radps = {30, 0, 0}}, kRadius_m);
    const auto& rolling = track_of(record, 1).segments.at(1);
    EXPECT_NEAR(rolling.velocity_mps.x, 2 - 2.0 / 7.0 * slip.x, 1e-14);
    EXPECT_NEAR(rolling.velocity_mps.y, -2.0 / 7.0 * slip.y, 1e-14);
    EXPECT_LT(rolling.velocity_mps.y, 0.0);
}

TEST(Motion, SpinAboutTheVerticalDecaysOnItsOwn) {
    const auto record =
        solved(model::open_table(), kRealistic, {ball_at(1, {0, 0}, {}, {0, 0, -21.8})});
    EXPECT_EQ(track_of(record, 1).segments.front().motion, Motion::Spinning);
    EXPECT_NEAR(record.duration_s, 21.8 / kRealistic.spin_deceleration_radps2, 1e-14);
    EXPECT_NEAR(state_of(record, 1, 1.0).spin_radps.z, -10.9, 1e-12);
}

TEST(Motion, SpinAboutTheVerticalStaysAtZeroWithinASegment) {
    const auto record = solved(model::open_table(), kRealistic,
                               {ball_at(1, {0, 0}, {1, 0}, rolling_spin({1, 0}) + Vec3{0, 0, 5})});
    EXPECT_EQ(track_of(record, 1).segments.size(), 2U) << "rolling, then rest";
    EXPECT_EQ(state_of(record, 1, 2.0).spin_radps.z, 0.0);
}

TEST(Motion, SnapFromSlideToRollAddsNoEnergy) {
    base::Random random(11);
    for (int i = 0; i < 1000; ++i) {
        model::BallState state{.position_m = {0, 0, kRadius_m}};
        for (int axis = 0; axis < 2; ++axis) {
            state.velocity_mps[axis] = random.uniform(-10, 10);
            state.spin_radps[axis] = random.uniform(-300, 300);
        }
        const Plan plan =
            plan_motion(kRealistic, kRadius_m, settled(kRealistic, kRadius_m, state), 0.0);
        const model::BallState before = state_at(plan.segment, plan.end_s);
        const model::BallState after = state_at_end(kRealistic, kRadius_m, plan);
        EXPECT_LE(energy_j(kRealistic, {}, after), energy_j(kRealistic, {}, before) + 1e-14);
        EXPECT_LT(speed_of(slip_mps(after, kRadius_m)), 1e-13);
    }
}

TEST(Motion, FliesAParabolaAndBouncesByTheTablesRestitution) {
    BallStart ball = ball_at(1, {0, 0}, {1, 0});
    ball.velocity_mps.z = 2.0;
    const double flight_s = 2 * 2.0 / kRealistic.gravity_mps2;
    const auto record = solved(model::open_table(), kRealistic, {ball});
    const auto landings = events_of(record, EventKind::Landing);
    ASSERT_GE(landings.size(), 2U);
    EXPECT_NEAR(landings[0].time_s, flight_s, 1e-14);
    EXPECT_NEAR(landings[1].time_s - landings[0].time_s, flight_s / 2, 1e-14);
    EXPECT_NEAR(state_of(record, 1, flight_s / 2).position_m.z,
                kRadius_m + 2.0 * 2.0 / (2 * kRealistic.gravity_mps2), 1e-14);
    EXPECT_LT(landings.size(), 8U) << "small bounces end";
}

TEST(Motion, WithoutFrictionABallNeverStops) {
    Parameters ice = kRealistic;
    ice.sliding_friction = 0.0;
    const auto record = solved(model::open_table(), ice, {ball_at(1, {0, 0}, {1, 0})});
    EXPECT_EQ(record.duration_s, 0.0) << "nothing happens any more";
    EXPECT_NEAR(state_of(record, 1, 7.0).position_m.x, 7.0, 1e-14);
}

}  // namespace
}  // namespace billiards::physics
