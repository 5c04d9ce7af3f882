// Holds `billiards-sim strike` against closed forms.
#include "tools/sim/strike.h"

#include "common/model/ball.h"
#include "tests/tools/sim/answered.h"

#include <cmath>

namespace billiards::tools {
namespace {

constexpr double kMass_kg = model::BallSpec{}.mass_kg;
constexpr double kRadius_m = model::BallSpec{}.radius_m;
constexpr double kCue_kg = 0.567;

TEST(Strike, ACentralHitIsTwiceTheCueByTheMasses) {
    const Json ball = answered(strike, R"({"cue_speed_mps":3,"angle_deg":90})");
    EXPECT_NEAR(ball["velocity_mps"][0].get<double>(), 0.0, 1e-15);
    EXPECT_NEAR(ball["velocity_mps"][1].get<double>(), 6 / (1 + kMass_kg / kCue_kg), 1e-14);
}

TEST(Strike, PowerImpliesTheSpeedOfTheSpring) {
    const Json ball = answered(strike, R"({"power":0.4,"angle_deg":0})");
    EXPECT_NEAR(ball["velocity_mps"][0].get<double>(), 200 * 0.01 * 0.4 / kMass_kg, 1e-14);
}

TEST(Strike, AnOffCentreHitLosesSpeedAndSpins) {
    const Json ball =
        answered(strike, R"({"cue_speed_mps":2,"angle_deg":0,"offset":[0.2,0.3],"squirt":false})");
    const double v = 4 / (1 + kMass_kg / kCue_kg + 2.5 * 0.13);
    EXPECT_NEAR(ball["velocity_mps"][0].get<double>(), v, 1e-14);
    EXPECT_NEAR(ball["spin_radps"][1].get<double>(), 2.5 * v * 0.3 / kRadius_m, 1e-11);
    EXPECT_NEAR(ball["spin_radps"][2].get<double>(), -2.5 * v * 0.2 / kRadius_m, 1e-11);
}

TEST(Strike, SquirtsAwayFromTheOffsetUnlessToldOtherwise) {
    const Json ball = answered(strike, R"({"cue_speed_mps":2,"angle_deg":0,"offset":[0.4,0]})");
    const double tangent = 2.5 * 0.4 * std::sqrt(0.84) / (1 + 30 + 2.5 * 0.84);
    EXPECT_NEAR(ball["velocity_mps"][1].get<double>() / ball["velocity_mps"][0].get<double>(),
                -tangent, 1e-14);
    const Json straight =
        answered(strike, R"({"cue_speed_mps":2,"angle_deg":0,"offset":[0.4,0],"squirt":false})");
    EXPECT_EQ(straight["velocity_mps"][1].get<double>(), 0.0);
}

TEST(Strike, AnElevatedCueDrivesTheBallDown) {
    const Json ball = answered(strike, R"({"cue_speed_mps":2,"angle_deg":0,"elevation_deg":30})");
    const double v = 4 / (1 + kMass_kg / kCue_kg);
    EXPECT_NEAR(ball["velocity_mps"][0].get<double>(), v * std::sqrt(0.75), 1e-14);
    EXPECT_NEAR(ball["velocity_mps"][2].get<double>(), -v / 2, 1e-14);
}

TEST(Strike, HeavierBallsLeaveSlower) {
    const Json ball =
        answered(strike, R"({"cue_speed_mps":3,"angle_deg":0,"physics":{"ball_mass_kg":0.567}})");
    EXPECT_NEAR(ball["velocity_mps"][0].get<double>(), 3.0, 1e-14);
}

struct BadCase {
    const char* input;
    const char* message;
};

TEST(Strike, NamesTheFieldThatIsWrong) {
    const BadCase cases[] = {
        {R"({"angle_deg":0})", "cue_speed_mps: is missing"},
        {R"({"cue_speed_mps":2})", "angle_deg: is missing"},
        {R"({"cue_speed_mps":-2,"angle_deg":0})", "cue_speed_mps: is out of range"},
        {R"({"cue_speed_mps":null,"angle_deg":0})", "cue_speed_mps: must be a number"},
        {R"({"cue_speed_mps":"2","angle_deg":0})", "cue_speed_mps: must be a number"},
        {R"({"power":0,"angle_deg":0})", "power: is out of range"},
        {R"({"power":1.01,"angle_deg":0})", "power: is out of range"},
        {R"({"power":null,"angle_deg":0})", "power: must be a number"},
        {R"({"power":1,"cue_speed_mps":2,"angle_deg":0})",
         "power: stands beside cue_speed_mps, which says the same"},
        {R"({"power":1,"angle_deg":null})", "angle_deg: must be a number"},
        {R"({"power":1,"angle_deg":0,"offset":[0.4,0.4]})", "offset: is out of range"},
        {R"({"power":1,"angle_deg":0,"offset":[0.4]})", "offset: must have 2 numbers"},
        {R"({"power":1,"angle_deg":0,"elevation_deg":90})", "elevation_deg: is out of range"},
        {R"({"power":1,"angle_deg":0,"squirt":"no"})", "squirt: must be true or false"},
        {R"({"power":1,"angle_deg":0,"physics":{"ball_mass_kg":0}})",
         "physics.ball_mass_kg: is out of range"},
        {R"({"power":1,"angle_deg":0,"physics":7})", "physics: must be an object"},
        {R"({"power":1,"power":1,"angle_deg":0})", "power: stands there twice"},
    };
    for (const BadCase& bad : cases) EXPECT_EQ(fault_of(strike, bad.input), bad.message);
}

}  // namespace
}  // namespace billiards::tools
