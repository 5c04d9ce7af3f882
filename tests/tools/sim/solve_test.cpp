// Holds the JSON of `billiards-sim solve` against its contract.
#include "tools/sim/solve.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace billiards::tools {
namespace {

Json solved(const std::string& text) {
    const Json input = Json::parse(text);
    Fault fault;
    const Json answer = solve(JsonNode(&input, "", fault), fault);
    EXPECT_FALSE(fault.is_found()) << fault.text();
    return answer;
}

/// The first event of this kind; null where there is none.
Json first_of(const Json& answer, const std::string& kind) {
    for (const Json& event : answer["events"]) {
        if (event["kind"] == kind) return event;
    }
    return {};
}

TEST(Solve, TellsTheClosedFormsOfASlide) {
    const Json answer = solved(R"({"table":"open","balls":{"cue":{"position_m":[0,0],
        "velocity_mps":[2,0,0]}},"sample_times_s":[0,0.1]})");
    const Json& rolls = answer["events"][0];
    EXPECT_EQ(rolls["kind"], "motion");
    EXPECT_EQ(rolls["ball"], "cue");
    EXPECT_EQ(rolls["to"], "rolling");
    EXPECT_NEAR(rolls["t"].get<double>(), 2 * 2 / (7 * 0.2 * 9.81), 1e-14);
    EXPECT_EQ(answer["events"][1]["to"], "resting");
    EXPECT_EQ(answer["final"]["cue"]["motion"], "resting");
    EXPECT_EQ(answer["duration_s"], answer["events"][1]["t"]);
    EXPECT_EQ(answer["samples"][0]["balls"]["cue"]["velocity_mps"][0], 2.0);
    EXPECT_NEAR(answer["samples"][1]["balls"]["cue"]["velocity_mps"][0].get<double>(), 2 - 0.1962,
                1e-12);
    EXPECT_TRUE(answer["min_gap_m"].is_null());
    EXPECT_EQ(answer["max_energy_rise_j"], 0.0);
    EXPECT_EQ(answer["hash"].get<std::string>().size(), 16U);
}

TEST(Solve, StrikesTheCueBall) {
    const Json answer = solved(R"({"table":"9ft","balls":{"cue":{"position_m":[-0.6,0]},
        "eight":{"position_m":[0.3,0]}},"shot":{"angle_deg":0,"power":0.2},"sample_times_s":[0]})");
    EXPECT_NEAR(answer["samples"][0]["balls"]["cue"]["velocity_mps"][0].get<double>(),
                0.4 / 0.170097, 1e-12);
    EXPECT_EQ(first_of(answer, "ball-ball")["balls"], (Json::array({"cue", "eight"})));
    EXPECT_GT(answer["min_gap_m"].get<double>(), -1e-12);
}

TEST(Solve, ReadsATableOfItsOwn) {
    const Json answer = solved(
        R"({"table":{"cushions":[{"from":[0.5,-1],"to":[0.5,1]},{"from":[-0.6,-1],"to":[-0.6,1]}],
        "jaws":[{"center":[0.5,2],"radius":0.1}],"pockets":[{"center":[-0.5,0],"radius":0.06}]},
        "physics":{"cushion":{"model":"mirror","restitution":1.0},"sliding_friction":0.0001},
        "balls":{"x":{"position_m":[0,0],"velocity_mps":[2,0,0]}}})");
    EXPECT_EQ(answer["events"][0]["kind"], "cushion");
    EXPECT_EQ(answer["events"][0]["index"], 0);
    EXPECT_FALSE(answer["events"][0].contains("held"));
    EXPECT_EQ(answer["events"][1]["kind"], "pocketed");
    EXPECT_EQ(answer["events"][1]["pocket"], 0);
    EXPECT_NEAR(answer["final"]["x"]["position_m"][0].get<double>(), -0.44, 1e-9);
}

TEST(Solve, ATableOfItsOwnEndsTwentyCentimetresOutside) {
    const Json answer = solved(R"({"table":{"cushions":[{"from":[0,1],"to":[1,1]}]},
        "balls":{"x":{"position_m":[0.5,0.9],"velocity_mps":[3,0,0]}}})");
    EXPECT_EQ(answer["events"].back()["kind"], "off-table");
    EXPECT_NEAR(answer["final"]["x"]["position_m"][0].get<double>(), 1.2, 1e-12);
}

TEST(Solve, MarksContactsThatWereHeldAlready) {
    const Json answer = solved(R"({"table":"9ft","balls":{"1":{"position_m":[0.3,0.606425],
        "velocity_mps":[0.5,3,0]}}})");
    EXPECT_EQ(answer["events"][0]["held"], true);
}

TEST(Solve, KnowsBallsOfOtherSizes) {
    const Json answer =
        solved(R"({"table":"open","physics":{"ball_radius_m":0.03,"ball_mass_kg":0.2},
        "balls":{"a":{"position_m":[0,0],"velocity_mps":[1,0,0]},
                 "b":{"position_m":[0.2,0.0,0.02],"radius_m":0.02,"mass_kg":0.1}},"sample_times_s":[0]})");
    EXPECT_EQ(answer["samples"][0]["balls"]["a"]["position_m"][2], 0.03);
    EXPECT_EQ(answer["samples"][0]["balls"]["b"]["position_m"][2], 0.02);
    EXPECT_FALSE(first_of(answer, "ball-ball").is_null());
}

TEST(Solve, ClassicHasNoSpinToGive) {
    const Json answer = solved(R"({"table":"9ft","physics":{"preset":"classic"},
        "balls":{"cue":{"position_m":[-0.6,0.1]}},"shot":{"angle_deg":0,"power":0.1,"offset":[0.3,0.3]},
        "sample_times_s":[0]})");
    EXPECT_NEAR(answer["samples"][0]["balls"]["cue"]["velocity_mps"][0].get<double>(),
                0.2 / 0.170097, 1e-12);
    EXPECT_EQ(answer["samples"][0]["balls"]["cue"]["motion"], "rolling");
}

}  // namespace
}  // namespace billiards::tools
