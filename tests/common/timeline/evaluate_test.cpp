// Shows that a timeline can be asked for any time, without an engine.
#include "common/timeline/evaluate.h"

#include <gtest/gtest.h>

namespace billiards::timeline {
namespace {

using base::Vec3;
using model::Motion;

BallTrack braking_ball() {
    // Rolls at 1 m/s, brakes at 0.5 m/s^2, rests after 2 s and 1 m, and spins a little longer.
    return {.ball = model::kCueBall,
            .radius_m = 0.03,
            .segments = {{.start_s = 0,
                          .position_m = {0, 0, 0.03},
                          .velocity_mps = {1, 0, 0},
                          .acceleration_mps2 = {-0.5, 0, 0},
                          .spin_radps = {0, 10, 6},
                          .spin_rate_radps2 = {0, -5, -2},
                          .motion = Motion::Rolling},
                         {.start_s = 2,
                          .position_m = {1, 0, 0.03},
                          .spin_radps = {0, 0, 2},
                          .spin_rate_radps2 = {0, 0, -2},
                          .motion = Motion::Spinning},
                         {.start_s = 3, .position_m = {1, 0, 0.03}}}};
}

TEST(Evaluate, FollowsThePolynomialWithinASegment) {
    const model::BallState state = evaluate(braking_ball(), 1.0);
    EXPECT_EQ(state.position_m, Vec3(0.75, 0, 0.03));
    EXPECT_EQ(state.velocity_mps, Vec3(0.5, 0, 0));
    EXPECT_EQ(state.spin_radps, Vec3(0, 5, 4));
    EXPECT_EQ(state.motion, Motion::Rolling);
}

TEST(Evaluate, TakesTheSegmentThatHasStarted) {
    EXPECT_EQ(evaluate(braking_ball(), 2.0).motion, Motion::Spinning);
    EXPECT_EQ(evaluate(braking_ball(), 2.5).spin_radps, Vec3(0, 0, 1));
}

TEST(Evaluate, BeforeTheStartIsTheStartAndAfterTheEndIsTheEnd) {
    EXPECT_EQ(evaluate(braking_ball(), -1).position_m, Vec3(0, 0, 0.03));
    EXPECT_EQ(evaluate(braking_ball(), 1e9).position_m, Vec3(1, 0, 0.03));
    EXPECT_EQ(evaluate(braking_ball(), 1e9).motion, Motion::Resting);
}

TEST(Evaluate, VerticalSpinThatHasDecayedStaysZeroWithinItsSegment) {
    Segment segment = braking_ball().segments[0];
    segment.spin_radps.z = 1;
    EXPECT_EQ(evaluate(segment, 0.25).spin_radps.z, 0.5);
    EXPECT_EQ(evaluate(segment, 1.5).spin_radps.z, 0.0);
    segment.spin_radps.z = -1;
    segment.spin_rate_radps2.z = 2;
    EXPECT_EQ(evaluate(segment, 1.5).spin_radps.z, 0.0);
}

}  // namespace
}  // namespace billiards::timeline
