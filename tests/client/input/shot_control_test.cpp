// Takes hands on the cue; gives whether the shot under construction follows them, and stays one
// that the engine accepts.
#include "client/input/shot_control.h"

#include "common/physics/simulate.h"

#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace billiards::client {
namespace {

TEST(ShotControl, PointsFromTheCueBallTowardsThePoint) {
    ShotControl control;
    control.aim_at({0.5, 0.1}, {0.5, 0.7});
    EXPECT_DOUBLE_EQ(control.shot().angle_rad, std::numbers::pi / 2);
    control.aim_at({0.5, 0.1}, {0.5, 0.1});
    EXPECT_DOUBLE_EQ(control.shot().angle_rad, std::numbers::pi / 2);
}

TEST(ShotControl, KeepsTheAimWhileTheCueIsPulledBack) {
    ShotControl control;
    control.set_angle(0.3);
    control.begin_pull();
    control.set_angle(1.0);
    control.turn(0.1);
    EXPECT_DOUBLE_EQ(control.shot().angle_rad, 0.3);
}

TEST(ShotControl, ShootsWithThePowerOfThePull) {
    ShotControl control;
    control.begin_pull();
    control.pull_to(0.37);
    EXPECT_DOUBLE_EQ(control.drawn_back_m(), 0.37);
    const auto shot = control.release();
    ASSERT_TRUE(shot);
    EXPECT_DOUBLE_EQ(shot->power, 0.37);
    EXPECT_FALSE(control.is_pulled());
}

TEST(ShotControl, TakesATinyPullForAChangeOfMind) {
    ShotControl control;
    control.begin_pull();
    control.pull_to(kLeastPull_m / 2);
    EXPECT_FALSE(control.release());
    EXPECT_FALSE(control.release()) << "it was not pulled at all";
}

TEST(ShotControl, DoesNotShootAfterThePullWasCancelled) {
    ShotControl control;
    control.begin_pull();
    control.pull_to(0.5);
    control.cancel_pull();
    EXPECT_FALSE(control.release());
}

TEST(ShotControl, StepsThePowerByAHundredthAndStaysWithinItsRange) {
    ShotControl control;
    control.set_power(0.5);
    control.step_power(1);
    EXPECT_DOUBLE_EQ(control.shot().power, 0.51);
    control.step_power(1000);
    EXPECT_DOUBLE_EQ(control.shot().power, 1.0);
    control.step_power(-1000);
    EXPECT_DOUBLE_EQ(control.shot().power, kPowerStep);
}

TEST(ShotControl, GivesOnlyShotsThatTheEngineAccepts) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    ShotControl control;
    for (const double wild : {kNan, 1e300, -1e300, 0.0, 0.7}) {
        control.set_angle(wild);
        control.set_power(wild);
        control.set_tip({wild, 0.3});
        control.set_elevation(wild);
        EXPECT_TRUE(physics::validate(control.shot())) << wild;
    }
    control.set_tip({3.0, 4.0});
    EXPECT_NEAR(control.shot().tip_left, 0.3, 1e-6);
    EXPECT_NEAR(control.shot().tip_up, 0.4, 1e-6);
    EXPECT_TRUE(physics::validate(control.shot()));
}

TEST(ShotControl, ForgetsSpinElevationAndCallWhenATurnStarts) {
    ShotControl control;
    control.set_angle(0.4);
    control.set_power(0.8);
    control.set_tip({0.1, 0.2});
    control.set_elevation(0.5);
    control.set_call(model::Safety{});
    control.start_turn();
    EXPECT_EQ(control.shot(), (model::Shot{.angle_rad = 0.4, .power = 0.8}));
    EXPECT_EQ(control.call(), model::Call{});
}

}  // namespace
}  // namespace billiards::client
