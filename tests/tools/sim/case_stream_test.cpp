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
    for (const char* text : {"nonsense", "{\"table\":}", "[[[[", ""}) {
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
         "balls.a.mass_kg: is out of range"},
        {R"({"table":"open","balls":{"a":{"position_m":[0,0]},"b":{"position_m":[0.01,0]}}})",
         "balls.a, balls.b: overlap"},
        {R"({"table":"9ft","balls":{"a":{"position_m":[7,0]}}})", "balls.a: outside the table"},
        {R"({"table":"open","physics":{"gravity_mps2":-1},"balls":{"a":{"position_m":[0,0]}}})",
         "physics.gravity_mps2: is out of range"},
        {R"({"table":"open","physics":{"preset":"moon"},"balls":{"a":{"position_m":[0,0]}}})",
         "physics.preset: must be one of realistic, classic"},
        {R"({"table":"open","physics":{"cushion":{"model":"jelly"}},"balls":{"a":{"position_m":[0,0]}}})",
         "physics.cushion.model: must be one of han2005, mathavan2010, stronge, mirror"},
        {R"({"table":"open","balls":{"a":{"position_m":[0,0]}},"shot":{"angle_deg":0,"power":1}})",
         "shot: there is no ball named cue"},
        {R"({"table":"open","balls":{"cue":{"position_m":[0,0]}},"shot":{"angle_deg":0,"power":2}})",
         "shot.power: is out of range"},
        {R"({"table":"open","balls":{"cue":{"position_m":[0,0]}},"shot":{"angle_deg":0,"power":1,"offset":[0.5,0.5]}})",
         "shot.offset: is out of range"},
        {R"({"table":{"cushions":[{"from":[0,0]}]},"balls":{"a":{"position_m":[0,0]}}})",
         "table.cushions[0].to: is missing"},
        {R"({"table":{},"balls":{"a":{"position_m":[0,0]}}})",
         "table.cushions: there must be some; a table without any is \"open\""},
        {R"({"table":{"cushions":[]},"balls":{"a":{"position_m":[0,0]}}})",
         "table.cushions: there must be some; a table without any is \"open\""},
        {R"({"table":{"cushions":[{"from":[0,0],"to":[0,0]}]},"balls":{"a":{"position_m":[1,1]}}})",
         "table.cushions[0]: is out of range"},
        {R"({"table":"open","physics":{"cushion":{"restitution":1.5}},"balls":{"a":{"position_m":[0,0]}}})",
         "physics.cushion.restitution: is out of range"},
        {R"({"table":"open","physics":{"gravity_mps2":null},"balls":{"a":{"position_m":[0,0]}}})",
         "physics.gravity_mps2: must be a number"},
        {R"({"table":"open","physics":{"ball_mass_kg":0},"balls":{"a":{"position_m":[0,0]}}})",
         "physics.ball_mass_kg: is out of range"},
        {R"({"table":"open","balls":{"a":{"position_m":[null,0]}}})",
         "balls.a.position_m[0]: must be a number"},
        {R"({"table":"open","balls":{"a":{"position_m":[1e999,0]}}})",
         "balls.a.position_m: has a number that is not finite"},
        {R"({"table":"open","balls":{"a":{"position_m":[0,0]},"a":{"position_m":[1,0]}}})",
         "balls.a: stands there twice"},
        {R"({"table":"open","balls":{"a":{"position_m":[0,0]}},"sample_times_s":[-1]})",
         "sample_times_s[0]: is out of range"},
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

TEST(CaseStream, TellsABallTooManyFromAFieldTooMany) {
    const auto with_balls = [](int count) {
        std::string text = R"({"table":"open","balls":{)";
        for (int i = 0; i < count; ++i) {
            const std::string number = std::to_string(i);
            text += (i == 0 ? "\"b" : ",\"b") + number + "\":{\"position_m\":[" + number + ",0]}";
        }
        return told_one(text + "}}");
    };
    EXPECT_EQ(with_balls(22).exit_code, 0);
    EXPECT_EQ(with_balls(1000).err, "balls: there must be 1 to 22\n");
    EXPECT_EQ(with_balls(20'000).err, "balls.b10000: is one field too many\n");
}

TEST(CaseStream, DeepNestingIsAnErrorLikeAnyOther) {
    const Told told = told_one(std::string(1'000'000, '['));
    EXPECT_EQ(told.exit_code, 2);
    EXPECT_TRUE(told.err.starts_with("input: is no JSON: ")) << told.err;
}

TEST(CaseStream, BytesThatAreNoTextAreAnErrorLikeAnyOther) {
    std::istringstream in("\xff\xfe\n");
    std::ostringstream out;
    EXPECT_EQ(answer_lines(in, out, solve), 0);
    EXPECT_TRUE(Json::parse(out.str()).contains("error"));
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
