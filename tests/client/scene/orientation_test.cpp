// Holds the turning of balls against rolls whose end is known.
#include "client/scene/orientation.h"

#include "common/base/elementary.h"

#include <cmath>
#include <gtest/gtest.h>

namespace billiards::client {
namespace {

using base::kPi;
using base::Vec3;

constexpr double kRadius_m = 0.028575;
constexpr model::BallId kBall{3};

timeline::Timeline one_ball(std::vector<timeline::Segment> segments) {
    return {{{.ball = kBall, .radius_m = kRadius_m, .segments = std::move(segments)}}};
}

/// Rolls along x without slowing down.
timeline::Timeline rolling(double speed_mps) {
    return one_ball({{.velocity_mps = {speed_mps, 0, 0},
                      .spin_radps = {0, speed_mps / kRadius_m, 0},
                      .motion = model::Motion::Rolling}});
}

/// The angle between two orientations.
double between(const glm::dquat& a, const glm::dquat& b) {
    return 2 * std::acos(std::min(1.0, std::fabs(glm::dot(a, b))));
}

TEST(Orientations, ABallThatRollsItsCircumferenceHasTurnedOnce) {
    Orientations orientations;
    const glm::dquat before = orientations.of(kBall);
    const double speed_mps = 0.7;
    const double once_round_s = 2 * kPi * kRadius_m / speed_mps;
    orientations.advance(rolling(speed_mps), once_round_s / 2);
    EXPECT_NEAR(between(orientations.of(kBall), before), kPi, 1e-9);
    orientations.advance(rolling(speed_mps), once_round_s);
    EXPECT_NEAR(between(orientations.of(kBall), before), 0.0, 1e-6);
}

TEST(Orientations, TheTopOfARollingBallMovesForward) {
    Orientations orientations;
    const glm::dquat before = orientations.of(kBall);
    orientations.advance(rolling(0.3), 0.01);
    const glm::dquat turn = orientations.of(kBall) * glm::inverse(before);
    EXPECT_GT((turn * Vec3(0, 0, 1)).x, 0.05);
}

TEST(Orientations, SpinThatChangesItsAxisIsFollowed) {
    // Half a turn about z in the first second, then half a turn about x.
    const auto timeline =
        one_ball({{.spin_radps = {0, 0, kPi}, .motion = model::Motion::Spinning},
                  {.start_s = 1.0, .spin_radps = {kPi, 0, 0}, .motion = model::Motion::Sliding},
                  {.start_s = 2.0, .motion = model::Motion::Resting}});
    Orientations orientations;
    const glm::dquat before = orientations.of(kBall);
    orientations.advance(timeline, 5.0);
    const glm::dquat expected =
        glm::angleAxis(kPi, Vec3(1, 0, 0)) * glm::angleAxis(kPi, Vec3(0, 0, 1)) * before;
    EXPECT_NEAR(between(orientations.of(kBall), expected), 0.0, 1e-6);
}

TEST(Orientations, ATimeHasOneOrientationHoweverOftenTheScreenIsDrawn) {
    const auto timeline =
        one_ball({{.spin_radps = {80, 20, 30}, .spin_rate_radps2 = {-20, 9, -12}}});
    Orientations at_once;
    at_once.advance(timeline, 2.345);
    Orientations often;
    for (double time_s = 0.0; time_s < 2.345; time_s += 0.0071) often.advance(timeline, time_s);
    often.advance(timeline, 2.345);
    EXPECT_EQ(often.of(kBall), at_once.of(kBall));
    often.advance(timeline, 0.5);  // Rewound.
    often.advance(timeline, 2.345);
    EXPECT_EQ(often.of(kBall), at_once.of(kBall));
}

TEST(Orientations, TheNextShotBeginsAsTheLastOneEnded) {
    Orientations orientations;
    orientations.advance(rolling(1.0), 1.0);
    const glm::dquat between_shots = orientations.of(kBall);
    orientations.start_shot();
    orientations.advance(rolling(1.0), -3.0);
    EXPECT_EQ(orientations.of(kBall), between_shots);
}

TEST(Orientations, AShotThatIsJoinedLateIsShownFromItsStrike) {
    Orientations seen;
    Orientations joined;
    for (Orientations* each : {&seen, &joined}) {
        each->advance(rolling(1.0), 1.0);
        each->start_shot();
    }
    seen.advance(rolling(2.0), 0.5);
    seen.advance(rolling(2.0), 3.0);
    joined.advance(rolling(2.0), 3.0);
    EXPECT_EQ(seen.of(kBall), joined.of(kBall));
}

TEST(Orientations, OfManyTurnsStayOneLong) {
    Orientations orientations;
    orientations.advance(rolling(10.0), 30.0);
    EXPECT_NEAR(glm::length(orientations.of(kBall)), 1.0, 1e-12);
}

}  // namespace
}  // namespace billiards::client
