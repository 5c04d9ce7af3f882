// Holds `billiards-sim collide` against closed forms and its contract.
#include "tools/sim/collide.h"

#include "tests/tools/sim/answered.h"

#include <cmath>

namespace billiards::tools {
namespace {

TEST(Collide, BallsExchangeTheNormalPartsOfTheirVelocities) {
    const Json after = answered(collide, R"({"kind":"ball-ball","model":"elastic",
        "a":{"position_m":[0,0],"velocity_mps":[2,1,0],"spin_radps":[3,4,5]},
        "b":{"position_m":[0.05715,0],"velocity_mps":[-1,0,0]}})");
    EXPECT_NEAR(after["a"]["velocity_mps"][0].get<double>(), -1.0, 1e-15);
    EXPECT_EQ(after["a"]["velocity_mps"][1], 1.0);
    EXPECT_NEAR(after["b"]["velocity_mps"][0].get<double>(), 2.0, 1e-15);
    EXPECT_EQ(after["b"]["velocity_mps"][1], 0.0);
    EXPECT_EQ(after["a"]["spin_radps"], (Json{3.0, 4.0, 5.0}));
    EXPECT_EQ(after["a"]["position_m"], (Json{0.0, 0.0, 0.028575}));
    EXPECT_EQ(after["b"]["position_m"], (Json{0.05715, 0.0, 0.028575}));
}

TEST(Collide, FrictionBetweenBallsFollowsItsFormula) {
    const double s = 3.0;  // Slip: a's velocity across the line of centres.
    const Json after = answered(collide, R"({"kind":"ball-ball",
        "a":{"position_m":[0,0],"velocity_mps":[2,3,0]},"b":{"position_m":[0.05715,0]}})");
    const double m = 0.170097;
    const double normal = m * 1.95 / 2 * 2;
    const double friction = std::min((0.009951 + 0.108 * std::exp(-1.088 * s)) * normal, m * s / 7);
    EXPECT_NEAR(after["a"]["velocity_mps"][0].get<double>(), 2 - normal / m, 1e-14);
    EXPECT_NEAR(after["b"]["velocity_mps"][1].get<double>(), friction / m, 1e-14);
    EXPECT_NEAR(after["b"]["spin_radps"][2].get<double>(), -2.5 * friction / m / 0.028575, 1e-11);
}

TEST(Collide, BallsMayHaveMassesAndSizesOfTheirOwn) {
    const Json after = answered(collide, R"({"kind":"ball-ball","model":"elastic",
        "a":{"position_m":[0,0],"velocity_mps":[1,0,0],"mass_kg":0.3},
        "b":{"position_m":[1,0],"mass_kg":0.1}})");
    EXPECT_NEAR(after["a"]["velocity_mps"][0].get<double>(), 0.5, 1e-15);
    EXPECT_NEAR(after["b"]["velocity_mps"][0].get<double>(), 1.5, 1e-15);
}

TEST(Collide, WhatPartsStaysAsItIs) {
    const char* const cases[] = {
        R"({"kind":"ball-ball","a":{"position_m":[0,0,0.1],"velocity_mps":[-1.0,1.0,2.0],"spin_radps":[1.0,2.0,3.0]},
            "b":{"position_m":[0.05715,0,0.1]}})",
        R"({"kind":"cushion","normal":[-1,0],"ball":{"position_m":[0,0],"velocity_mps":[-1.0,1.0,2.0],"spin_radps":[1.0,2.0,3.0]}})"};
    for (const char* const input : cases) {
        const Json after = answered(collide, input);
        const Json& ball = after.contains("a") ? after["a"] : after["ball"];
        EXPECT_EQ(ball["velocity_mps"], (Json{-1.0, 1.0, 2.0}));
        EXPECT_EQ(ball["spin_radps"], (Json{1.0, 2.0, 3.0}));
    }
}

TEST(Collide, HanFollowsItsFormulasAtAnyAngleOfTheCushion) {
    // Han 2005 for a ball without spin that comes at 45 degrees, the nose 0.27 R above its centre.
    const double sine = 0.27;
    const double cosine = std::sqrt(1 - sine * sine);
    const double v = std::sqrt(0.5);
    const double p_z = 1.85 * v * cosine;
    const double slip = std::hypot(v * sine, v);
    const double grip = std::min(2.0 / 7.0 * slip, 0.2 * p_z);
    const double x = v - grip * (v * sine / slip) * sine - p_z * cosine;
    const double y = v - grip * v / slip;
    // The cushion lies along the diagonal: into it is (1, 1) / sqrt 2, along it (-1, 1) / sqrt 2.
    const Json after = answered(collide, R"({"kind":"cushion","model":"han2005","normal":[-5,-5],
        "nose_height_m":0.03629025,"ball":{"position_m":[0,0],"velocity_mps":[0,1,0]}})");
    const double root = std::sqrt(0.5);
    EXPECT_NEAR(after["ball"]["velocity_mps"][0].get<double>(), (x - y) * root, 1e-14);
    EXPECT_NEAR(after["ball"]["velocity_mps"][1].get<double>(), (x + y) * root, 1e-14);
}

TEST(Collide, TheModelBesideTheKindComesBeforeThatOfThePhysics) {
    const Json after = answered(collide, R"({"kind":"cushion","model":"mirror","normal":[-1,0],
        "physics":{"cushion":{"model":"stronge","restitution":0.5}},
        "ball":{"position_m":[0,0],"velocity_mps":[2,1,0]}})");
    EXPECT_EQ(after["ball"]["velocity_mps"], (Json{-1.0, 0.5, 0.0}));
}

TEST(Collide, ABallThatFliesOverTheNoseGoesOn) {
    const Json after = answered(collide, R"({"kind":"cushion","normal":[-1,0],
        "ball":{"position_m":[0,0,0.07],"velocity_mps":[2,1,0.5]}})");
    EXPECT_EQ(after["ball"]["velocity_mps"], (Json{2.0, 1.0, 0.5}));
}

TEST(Collide, SlowBallsFollowTheModelToo) {
    const Json after = answered(collide, R"({"kind":"ball-ball",
        "a":{"position_m":[0,0],"velocity_mps":[1e-4,0,0]},"b":{"position_m":[0.05715,0]}})");
    EXPECT_NEAR(after["b"]["velocity_mps"][0].get<double>(), 1e-4 * 1.95 / 2, 1e-18);
}

struct BadCase {
    const char* input;
    const char* message;
};

TEST(Collide, NamesTheFieldThatIsWrong) {
    const BadCase cases[] = {
        {R"({})", "kind: is missing"},
        {R"({"kind":"jaw"})", "kind: must be one of ball-ball, cushion"},
        {R"({"kind":"ball-ball","model":"han2005"})", "model: must be one of frictional, elastic"},
        {R"({"kind":"cushion","model":"jelly"})",
         "model: must be one of han2005, mathavan2010, stronge, mirror"},
        {R"({"kind":"ball-ball","b":{"position_m":[0,1]}})", "a.position_m: is missing"},
        {R"({"kind":"ball-ball","a":{"position_m":[0,1]},"b":{"position_m":[0,1]}})",
         "b.position_m: is where a is"},
        {R"({"kind":"ball-ball","a":{"position_m":[0,1],"mass_kg":0},"b":{"position_m":[0,2]}})",
         "a.mass_kg: is out of range"},
        {R"({"kind":"ball-ball","a":{"position_m":[0,1],"radius_m":-1},"b":{"position_m":[0,2]}})",
         "a.radius_m: is out of range"},
        {R"({"kind":"cushion","normal":[1,0],"ball":{"position_m":[0,0],"velocity_mps":null}})",
         "ball.velocity_mps: is missing"},
        {R"({"kind":"cushion","normal":[1,0],"ball":{"position_m":[0,0],"spin_radps":[0,null,0]}})",
         "ball.spin_radps[1]: must be a number"},
        {R"({"kind":"cushion","normal":[1,0],"ball":{"position_m":[0,0],"velocity_mps":[1e3,0,0]}})",
         "ball.velocity_mps: is out of range"},
        {R"({"kind":"cushion","normal":[0,0],"ball":{"position_m":[0,0]}})",
         "normal: must point from the cushion to the table"},
        {R"({"kind":"cushion","ball":{"position_m":[0,0]}})", "normal: is missing"},
        {R"({"kind":"cushion","normal":[1,0],"nose_height_m":0.2,"ball":{"position_m":[0,0]}})",
         "nose_height_m: is out of range"},
        {R"({"kind":"cushion","normal":[1,0],"nose_height_m":null,"ball":{"position_m":[0,0]}})",
         "nose_height_m: must be a number"},
        {R"({"kind":"cushion","normal":[1,0],"ball":7})", "ball: must be an object"},
        {R"({"kind":"cushion","physics":{"cushion":{"friction":-1}}})",
         "physics.cushion.friction: is out of range"},
    };
    for (const BadCase& bad : cases) EXPECT_EQ(fault_of(collide, bad.input), bad.message);
}

}  // namespace
}  // namespace billiards::tools
