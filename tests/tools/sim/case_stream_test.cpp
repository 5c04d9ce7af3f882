// Holds how bad cases are told: alone by the exit status, in a stream on their own line.
#include "tools/sim/case_stream.h"

#include "tools/sim/solve.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace billiards::tools {
namespace {

struct Told {
    int exit_code = 0;
    std::string out;
    std::string err;
};

Told told_one(const std::string& input) {
    std::istringstream in(input);
    std::ostringstream out;
    std::ostringstream err;
    const int code = answer_one(in, out, err, solve);
    return {code, out.str(), err.str()};
}

struct BadCase {
    const char* input;
    const char* message;
};

TEST(CaseStream, SaysWhereTextStopsBeingJson) {
    for (const char* text : {"nonsense", "{\"table\":}", "{\"balls\":1e999}", ""}) {
        std::istringstream in(text);
        std::ostringstream out;
        std::ostringstream err;
        EXPECT_EQ(answer_one(in, out, err, solve), 2);
        const std::string said = err.str();
        EXPECT_TRUE(said.starts_with("input: is no JSON: ")) << said;
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    }
}

TEST(CaseStream, NamesTheFieldThatIsWrong) {
    const BadCase cases[] = {
        {"[]", "input: must be one JSON object"},
        {R"({})", "table: is missing"},
        {R"({"table":"10ft","balls":{}})", "table: must be one of 7ft, 8ft, 9ft, open"},
        {R"({"table":"open"})", "balls: there must be 1 to 22"},
        {R"({"table":"open","balls":[1]})", "balls: must be an object"},
        {R"({"table":"open","balls":{"a":{}}})", "balls.a.position_m: is missing"},
        {R"({"table":"open","balls":{"a":{"position_m":[1]}}})",
         "balls.a.position_m: must have 3 numbers"},
        {R"({"table":"open","balls":{"a":{"position_m":[1,"x"]}}})",
         "balls.a.position_m[1]: must be a number"},
        {R"({"table":"open","balls":{"a":{"position_m":[0,0],"mass_kg":-1}}})",
         "balls.a mass_kg: is out of range"},
        {R"({"table":"open","balls":{"a":{"position_m":[0,0]},"b":{"position_m":[0.01,0]}}})",
         "balls.a, balls.b: overlap"},
        {R"({"table":"9ft","balls":{"a":{"position_m":[7,0]}}})", "balls.a: outside the table"},
        {R"({"table":"open","physics":{"gravity_mps2":-1},"balls":{"a":{"position_m":[0,0]}}})",
         "physics.gravity_mps2: is out of range"},
        {R"({"table":"open","physics":{"preset":"moon"},"balls":{"a":{"position_m":[0,0]}}})",
         "physics.preset: must be one of realistic, classic"},
        {R"({"table":"open","physics":{"cushion":{"model":"jelly"}},"balls":{"a":{"position_m":[0,0]}}})",
         "physics.cushion.model: must be one of han2005, mirror"},
        {R"({"table":"open","balls":{"a":{"position_m":[0,0]}},"shot":{"angle_deg":0,"power":1}})",
         "shot: there is no ball named cue"},
        {R"({"table":"open","balls":{"cue":{"position_m":[0,0]}},"shot":{"angle_deg":0,"power":2}})",
         "shot.power: is out of range"},
        {R"({"table":"open","balls":{"cue":{"position_m":[0,0]}},"shot":{"angle_deg":0,"power":1,"offset":[0.5,0.5]}})",
         "shot.offset: is out of range"},
        {R"({"table":{"cushions":[{"from":[0,0]}]},"balls":{"a":{"position_m":[0,0]}}})",
         "table.cushions[0].to: is missing"},
        {R"({"table":"open","balls":{"a":{"position_m":[0,0]}},"sample_times_s":["x"]})",
         "sample_times_s[0]: must be a number"},
    };
    for (const BadCase& bad : cases) {
        const Told told = told_one(bad.input);
        EXPECT_EQ(told.exit_code, 2) << bad.input;
        EXPECT_EQ(told.err, std::string(bad.message) + "\n") << bad.input;
        EXPECT_TRUE(told.out.empty()) << bad.input;
    }
}

TEST(CaseStream, KeepsErrorsOnTheirLineAndGoesOn) {
    std::istringstream in(
        "{\"table\":\"open\",\"balls\":{\"a\":{\"position_m\":[0,0]}}}\n"
        "\n"
        "oops\n"
        "{\"table\":\"open\",\"balls\":{\"b\":{\"position_m\":[0,0]}}}\n");
    std::ostringstream out;
    EXPECT_EQ(answer_lines(in, out, solve), 0);
    std::istringstream lines(out.str());
    std::vector<Json> answers;
    for (std::string line; std::getline(lines, line);) answers.push_back(Json::parse(line));
    ASSERT_EQ(answers.size(), 3U);
    EXPECT_TRUE(answers[0].contains("hash"));
    EXPECT_TRUE(answers[1]["error"].get<std::string>().starts_with("input: is no JSON"));
    EXPECT_TRUE(answers[2]["final"].contains("b"));
}

}  // namespace
}  // namespace billiards::tools
