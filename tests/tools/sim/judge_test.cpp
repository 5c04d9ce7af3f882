// Holds `billiards-sim judge` against rulings told in tests/golden/rulings, and against input that
// is none.
#include "tools/sim/judge.h"

#include "common/base/check.h"
#include "common/base/random.h"
#include "tools/sim/words.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

namespace billiards::tools {
namespace {

std::string text_of_file(const std::string& path) {
    const std::ifstream file(path);
    CHECK(file.good());
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A ruling as somebody who knows the rules, and not this code, would write it down.
struct Told {
    std::string name;
    Json input;
    Json output;  ///< What is absent here has its usual value.

    friend void PrintTo(const Told& told, std::ostream* out) { *out << told.name; }
};

std::vector<Told> told_in(const std::string& file) {
    std::vector<Told> all;
    for (const Json& each : Json::parse(text_of_file(GOLDEN_RULINGS_FOLDER "/" + file))) {
        all.push_back({each.at("name"), each.at("input"), each.at("output")});
    }
    return all;
}

/// "A jaw is a cushion" is AJawIsACushion.
std::string test_name(const testing::TestParamInfo<Told>& info) {
    std::string name;
    bool starts_word = true;
    for (const char letter : info.param.name) {
        const bool is_part = std::isalnum(static_cast<unsigned char>(letter)) != 0;
        if (is_part) name += starts_word ? static_cast<char>(std::toupper(letter)) : letter;
        starts_word = !is_part;
    }
    return name;
}

Json judged(const Json& input) {
    Fault fault;
    Json answer = judge(JsonNode(&input, "", fault), fault);
    EXPECT_FALSE(fault.is_found()) << fault.text();
    return answer;
}

std::string fault_of(const std::string& text) {
    const Json input = Json::parse(text);
    Fault fault;
    judge(JsonNode(&input, "", fault), fault);
    return fault.is_found() ? fault.text() : "";
}

/// Each field that the told output leaves out.
const Json kUsual = Json::parse(R"({"fouls":[],"turn_continues":false,"in_hand":"none","choices":[],
    "chooser":null,"groups":null,"spotted":[],"winner":null,"consecutive_fouls":[0,0],
    "score_change":[0,0],"rerack":null})");

class Ruling : public testing::TestWithParam<Told> {};

TEST_P(Ruling, IsAsTold) {
    Json expected = kUsual;
    expected.update(GetParam().output);
    const Json verdict = judged(GetParam().input);
    EXPECT_EQ(verdict.size(), expected.size());
    for (const auto& [field, value] : expected.items()) {
        EXPECT_EQ(verdict.value(field, Json("absent")), value) << field;
    }
}

INSTANTIATE_TEST_SUITE_P(EightBall, Ruling, testing::ValuesIn(told_in("eight_ball.json")),
                         test_name);
INSTANTIATE_TEST_SUITE_P(NineBall, Ruling, testing::ValuesIn(told_in("nine_ball.json")), test_name);
INSTANTIATE_TEST_SUITE_P(TenBall, Ruling, testing::ValuesIn(told_in("ten_ball.json")), test_name);
INSTANTIATE_TEST_SUITE_P(StraightPool, Ruling, testing::ValuesIn(told_in("straight_pool.json")),
                         test_name);
INSTANTIATE_TEST_SUITE_P(Practice, Ruling, testing::ValuesIn(told_in("practice.json")), test_name);

TEST(Judge, WritesEveryFieldInTheOrderOfTheContract) {
    const Json input = Json::parse(R"({"game":"eight-ball","events":[
        {"t":0.2,"kind":"ball-ball","balls":["cue","1"]},{"t":0.9,"kind":"pocketed","ball":"8",
        "pocket":0},{"t":1,"kind":"off-table","ball":"3"}]})");
    EXPECT_EQ(judged(input).dump(),
              R"({"fouls":["ball-off-table"],"turn_continues":false,"next_player":1,)"
              R"("in_hand":"behind-head-string","choices":["spot-eight","rebreak-self"],)"
              R"("chooser":1,"groups":null,"spotted":[],"winner":null,)"
              R"("consecutive_fouls":[0,0],"score_change":[0,0],"rerack":null,)"
              R"("reason":"eight-on-foul-break"})");
}

TEST(Judge, TakesTheUsualStateWhereItIsAbsent) {
    const std::string events = R"("events":[{"t":0.1,"kind":"ball-ball","balls":["cue","3"]},
        {"t":0.5,"kind":"pocketed","ball":"3","pocket":1}])";
    const Json bare = Json::parse(R"({"game":"eight-ball",)" + events + "}");
    const Json told = Json::parse(
        R"({"game":"eight-ball","options":{"call":true},"state":{"phase":"break","shooter":0,
        "groups":null,"on_table":[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15],"in_hand":"none",
        "consecutive_fouls":[0,0],"push_out_allowed":false,"behind_head_string":[],"scores":[0,0],
        "target":100},"call":null,)" +
        events + "}");
    EXPECT_EQ(judged(bare), judged(told));
    EXPECT_EQ(judged(bare)["reason"], "break-pot");
    const Json grouped =
        Json::parse(R"({"game":"eight-ball","state":{"phase":"groups"},)" + events + "}");
    EXPECT_EQ(judged(grouped)["groups"], (Json::array({"solids", "stripes"})));
}

TEST(Judge, IgnoresWhatIsNotNamed) {
    const Json input = Json::parse(R"({"game":"eight-ball","comment":1,"options":{"house":"x"},
        "state":{"frozen":["5"],"phase":"open"},"events":[{"t":0,"kind":"ball-ball",
        "balls":["cue","5"],"speed":2},{"kind":"motion"},{"kind":"landing","ball":99},
        {"t":1,"kind":"cushion","ball":"5","frozen":true}]})");
    EXPECT_EQ(judged(input)["reason"], "nothing-potted");
}

struct Bad {
    const char* input;
    const char* fault;
};

TEST(Judge, NamesTheFieldThatIsWrong) {
    const Bad cases[] = {
        {R"({})", "game: is missing"},
        {R"({"game":"snooker","events":[]})",
         "game: must be one of eight-ball, nine-ball, ten-ball, straight-pool, practice"},
        {R"({"game":8,"events":[]})", "game: must be a string"},
        {R"({"game":"eight-ball"})", "events: is missing"},
        {R"({"game":"eight-ball","events":{}})", "events: must be a list"},
        {R"({"game":"eight-ball","events":[3]})", "events[0]: must be an object"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"bounce"}]})",
         "events[0].kind: must be one of ball-ball, cushion, jaw, pocketed, motion, head-string, "
         "landing, off-table"},
        {R"({"game":"eight-ball","events":[{"kind":"off-table","ball":"3"}]})",
         "events[0].t: is missing"},
        {R"({"game":"eight-ball","events":[{"t":"0","kind":"off-table","ball":"3"}]})",
         "events[0].t: must be a number"},
        {R"({"game":"eight-ball","events":[{"t":-1,"kind":"off-table","ball":"3"}]})",
         "events[0].t: must not be negative"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"off-table","ball":"16"}]})",
         "events[0].ball: must be \"cue\" or a ball from 1 to 15"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"off-table","ball":"0"}]})",
         "events[0].ball: must be \"cue\" or a ball from 1 to 15"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"off-table","ball":"8 "}]})",
         "events[0].ball: must be \"cue\" or a ball from 1 to 15"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"off-table","ball":"eight"}]})",
         "events[0].ball: must be \"cue\" or a ball from 1 to 15"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"off-table","ball":16}]})",
         "events[0].ball: must be a whole number from 1 to 15"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"off-table","ball":2.5}]})",
         "events[0].ball: must be a whole number from 1 to 15"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"ball-ball","balls":["cue"]}]})",
         "events[0].balls: must be two balls"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"ball-ball","balls":["3",3]}]})",
         "events[0].balls: must be two different balls"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"pocketed","ball":3,"pocket":6}]})",
         "events[0].pocket: must be a whole number from 0 to 5"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"pocketed","ball":3}]})",
         "events[0].pocket: is missing"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"jaw","ball":3,"held":1}]})",
         "events[0].held: must be true or false"},
        {R"({"game":"eight-ball","events":[{"t":0,"kind":"head-string","ball":"cue",
            "direction":2}]})",
         "events[0].direction: must be a whole number from -1 to 1"},
        {R"({"game":"eight-ball","call":"bank","events":[]})",
         "call: must be one of safety, push-out"},
        {R"({"game":"eight-ball","call":5,"events":[]})", "call: must be an object"},
        {R"({"game":"eight-ball","call":{"ball":5},"events":[]})", "call.pocket: is missing"},
        {R"({"game":"eight-ball","call":{"ball":"cue","pocket":1},"events":[]})",
         "call.ball: must be an object ball"},
        {R"({"game":"eight-ball","options":{"call":"yes"},"events":[]})",
         "options.call: must be true or false"},
        {R"({"game":"eight-ball","state":{"phase":"end"},"events":[]})",
         "state.phase: must be one of break, open, groups, after-break"},
        {R"({"game":"eight-ball","state":{"shooter":2},"events":[]})",
         "state.shooter: must be a whole number from 0 to 1"},
        {R"({"game":"eight-ball","state":{"in_hand":"kitchen"},"events":[]})",
         "state.in_hand: must be one of none, anywhere, behind-head-string"},
        {R"({"game":"eight-ball","state":{"on_table":[17]},"events":[]})",
         "state.on_table[0]: must be a whole number from 1 to 15"},
        {R"({"game":"eight-ball","state":{"on_table":[]},"events":[]})",
         "state.on_table: must have a ball to play"},
        {R"({"game":"eight-ball","state":{"phase":"groups","groups":["solids"]},"events":[]})",
         "state.groups: must have one value a player"},
        {R"({"game":"eight-ball","state":{"phase":"groups","groups":["solids","solids"]},
            "events":[]})",
         "state.groups: must be one group a player"},
        {R"({"game":"eight-ball","state":{"consecutive_fouls":[0,-1]},"events":[]})",
         "state.consecutive_fouls[1]: must be a whole number from 0 to 1000000"},
        {R"({"game":"eight-ball","state":{"scores":[0,1e12]},"events":[]})",
         "state.scores[1]: must be a whole number from -1000000 to 1000000"},
        {R"({"game":"eight-ball","state":{"target":0},"events":[]})",
         "state.target: must be a whole number from 1 to 1000"},
    };
    for (const auto& [input, fault] : cases) EXPECT_EQ(fault_of(input), fault) << input;
}

TEST(Judge, TakesNoMoreEventsThanAShotCanHave) {
    Json input{{"game", "eight-ball"}, {"events", Json::array()}};
    for (int i = 0; i <= 20'000; ++i) input["events"].push_back({{"kind", "motion"}});
    EXPECT_EQ(fault_of(input.dump()), "events: must be at most 20000");
}

/// Anything that can be written down, whether it can happen or not.
Json random_input(const char* game, base::Random& random) {
    const auto one_of = [&](const auto& words) { return words[random.below(words.size())]; };
    const auto some_balls = [&] {
        Json balls = Json::array();
        for (int ball = 1; ball <= 15; ++ball) {
            if (random.below(3) == 0) balls.push_back(ball);
        }
        return balls;
    };
    Json input{{"game", game}, {"call", Json()}, {"events", Json::array()}};
    input["options"] = {{"call", random.below(2) == 0},
                        {"ten_wins_any_time", random.below(2) == 0}};
    input["state"] = {{"phase", one_of(words_of(rules::Phase{}))},
                      {"shooter", random.below(2)},
                      {"in_hand", one_of(words_of(rules::Zone{}))},
                      {"behind_head_string", some_balls()},
                      {"consecutive_fouls", {random.below(3), random.below(3)}},
                      {"push_out_allowed", random.below(2) == 0},
                      {"scores", {random.below(101), random.below(101)}}};
    if (Json balls = some_balls(); !balls.empty()) input["state"]["on_table"] = balls;
    const auto ball = [&] {
        const auto number = random.below(16);
        return number == 0 ? Json("cue") : Json(number);
    };
    const Json calls[] = {
        {{"ball", 1 + random.below(15)}, {"pocket", random.below(2)}}, "safety", "push-out"};
    if (const auto said = random.below(4); said < 3) input["call"] = calls[said];
    for (auto left = random.below(8); left > 0; --left) {
        Json event{{"t", random.below(4)},
                   {"kind", one_of(words_of(model::EventKind{}))},
                   {"ball", ball()},
                   {"pocket", random.below(2)}};
        event["balls"] = {"cue", 1 + random.below(15)};
        input["events"].push_back(event);
    }
    return input;
}

void expect_sound(const Json& verdict, const Json& shooter) {
    EXPECT_EQ(verdict["choices"].empty(), verdict["chooser"].is_null());
    if (!verdict["chooser"].is_null()) {
        EXPECT_EQ(verdict["chooser"], verdict["next_player"]);
        EXPECT_EQ(verdict["turn_continues"], false);
        EXPECT_TRUE(verdict["winner"].is_null());
    }
    if (!verdict["winner"].is_null()) {
        EXPECT_EQ(verdict["winner"], verdict["next_player"]);
        EXPECT_EQ(verdict["turn_continues"], false);
        EXPECT_EQ(verdict["in_hand"], "none");
        EXPECT_TRUE(verdict["spotted"].empty());
    }
    EXPECT_TRUE(verdict["turn_continues"] == false || verdict["next_player"] == shooter);
    EXPECT_TRUE(std::ranges::is_sorted(verdict["spotted"]));
}

TEST(Judge, RulesSoundlyOnWhateverIsTold) {
    base::Random random(7);
    for (const char* game : words_of(rules::Game{})) {
        for (int i = 0; i < 400; ++i) {
            const Json input = random_input(game, random);
            SCOPED_TRACE(input.dump());
            expect_sound(judged(input), input["state"]["shooter"]);
        }
    }
}

template <class Enum>
std::vector<std::string> undocumented() {
    static const std::string page = text_of_file(RULES_PAGE);
    std::vector<std::string> missing;
    for (const std::string word : words_of(Enum{})) {
        if (page.find("| `" + word + "` |") == std::string::npos) missing.push_back(word);
    }
    return missing;
}

TEST(Judge, SaysNothingThatThePageOnRulesDoesNotExplain) {
    EXPECT_EQ(undocumented<rules::Reason>(), std::vector<std::string>{});
    EXPECT_EQ(undocumented<rules::Foul>(), std::vector<std::string>{});
    EXPECT_EQ(undocumented<rules::Choice>(), std::vector<std::string>{});
}

TEST(Words, NameTheLastOfEachList) {
    EXPECT_STREQ(word_of(rules::Reason::Practice), "practice");
    EXPECT_STREQ(word_of(rules::Foul::BreakingFoul), "breaking-foul");
    EXPECT_STREQ(word_of(rules::Choice::PassBack), "pass-back");
    EXPECT_STREQ(word_of(rules::Zone::BehindHeadString), "behind-head-string");
    EXPECT_STREQ(word_of(rules::Phase::AfterBreak), "after-break");
    EXPECT_STREQ(word_of(rules::Rerack::Fifteen), "fifteen");
    EXPECT_STREQ(word_of(rules::Game::Practice), "practice");
    EXPECT_STREQ(word_of(model::EventKind::OffTable), "off-table");
}

}  // namespace
}  // namespace billiards::tools
