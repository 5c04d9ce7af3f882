// Holds `billiards-sim replay` against the recorded matches, whole and spoilt.
#include "tools/sim/replay.h"

#include "common/replay/replay_file.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

namespace billiards::tools {
namespace {

namespace fs = std::filesystem;
using protocol::Bytes;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

std::string content_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

fs::path golden(const std::string& extension) {
    return fs::path(GOLDEN_REPLAY_FOLDER) /
           ("engine-" + std::string(replay::kEngineVersion) + extension);
}

struct Ran {
    int exit_code = 0;
    std::string out;
    std::string err;
};

Ran run(const ReplayOptions& options) {
    std::ostringstream out;
    std::ostringstream err;
    const int exit_code = replay_file(options, out, err);
    return {exit_code, out.str(), err.str()};
}

class SpoiltReplay : public testing::Test {
  protected:
    Ran run_on(const std::string& content, bool is_verified) {
        std::ofstream(file_, std::ios::binary) << content;
        return run({.file = file_, .is_verified = is_verified});
    }

    std::string whole_ = content_of(golden(".billiards"));
    support::TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "match.billiards";
};

TEST(Replay, IsPrintedLikeAScore) {
    for (const auto& entry : fs::directory_iterator(GOLDEN_REPLAY_FOLDER)) {
        if (entry.path().extension() != ".billiards") continue;
        const Ran ran = run({.file = entry.path(), .is_printed = true});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
        EXPECT_EQ(ran.out, content_of(fs::path(entry.path()).replace_extension(".txt")));
    }
}

TEST(Replay, OfThisEngineIsVerified) {
    const Ran ran = run({.file = golden(".billiards"), .is_verified = true});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, MatchesRegex("verified: [0-9]+ shots, solved and judged again by engine "
                                      "[0-9.]+ in [0-9.]+ ms\n"));
}

TEST(Replay, PrintsAndVerifiesWhereBothAreAsked) {
    const Ran ran = run({.file = golden(".billiards"), .is_printed = true, .is_verified = true});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, StartsWith(content_of(golden(".txt"))));
    EXPECT_THAT(ran.out, HasSubstr("verified: "));
}

std::string content_of(const replay::Replay& replay) {
    const Bytes bytes = replay::to_bytes(replay).value();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A match of these commands, each by its seat; none is a shot.
Ran run_on_match_of(const std::vector<std::pair<model::Seat, match::Command>>& commands,
                    const match::Settings& settings = {}) {
    const support::TemporaryFolder folder;
    const fs::path file = folder.path() / "match.billiards";
    replay::Replay replay;
    replay.header.settings = settings;
    replay.header.players = {{"Ada#3f21", "Grace#84ac"}};
    for (const auto& [seat, command] : commands) {
        replay.entries.emplace_back();
        replay.entries.back().seat = seat;
        replay.entries.back().command = command;
    }
    std::ofstream(file, std::ios::binary) << content_of(replay);
    return run({.file = file, .is_printed = true});
}

TEST(Replay, TellsHowAMatchEndedWithoutAShot) {
    const model::TurnNumber turn{1};
    const Ran drawn =
        run_on_match_of({{model::Seat::First, match::Offer{turn, match::OfferKind::Draw}},
                         {model::Seat::Second, match::Answer{turn, true}}});
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_THAT(drawn.out, HasSubstr("Ada offers a draw"));
    EXPECT_THAT(drawn.out, HasSubstr("\nthe match is drawn 0-0\n"));
    const Ran conceded = run_on_match_of({{model::Seat::First, match::Concede{}}});
    EXPECT_THAT(conceded.out, HasSubstr("\nGrace wins the match 0-0: Ada conceded\n"));
}

TEST(Replay, OfStraightPoolTellsThePointsOfARack) {
    match::Settings settings;
    settings.game = rules::Game::StraightPool;
    settings.options.target_points = 25;
    const Ran ran = run_on_match_of({{model::Seat::First, match::Concede{}}}, settings);
    EXPECT_THAT(ran.out, HasSubstr("\nstraight-pool, 25 points, race to 3, "));
}

TEST_F(SpoiltReplay, OfAnOldEngineIsPrintedButNotVerified) {
    auto old = replay::from_bytes(std::as_bytes(std::span(whole_)))->replay;
    old.header.engine = "0.9";
    EXPECT_EQ(run_on(content_of(old), false).exit_code, 0);
    const Ran ran = run_on(content_of(old), true);
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.err, StartsWith("not verified: played by engine 0.9, this is engine "));
}

TEST_F(SpoiltReplay, CutShortIsPrintedUpToThereAndNotVerified) {
    const std::string half = whole_.substr(0, whole_.size() / 2);
    const Ran printed = run_on(half, false);
    EXPECT_EQ(printed.exit_code, 2);
    EXPECT_THAT(printed.out, HasSubstr("   5. "));
    EXPECT_THAT(content_of(golden(".txt")), StartsWith(printed.out));
    EXPECT_THAT(printed.err, HasSubstr("ends too early"));
    EXPECT_THAT(printed.err, HasSubstr("shown up to there"));
    const Ran verified = run_on(half, true);
    EXPECT_EQ(verified.exit_code, 2);
    EXPECT_EQ(verified.out, "");
}

TEST_F(SpoiltReplay, EditedIsRefusedWithTheReason) {
    whole_[whole_.size() / 2] ^= 1;
    const Ran ran = run_on(whole_, true);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr(file_.string() + ": the file was changed after it was written"));
}

TEST_F(SpoiltReplay, OversizedIsRefusedWithTheReason) {
    whole_.resize(replay::kMaxFileBytes + 1);
    const Ran ran = run_on(whole_, false);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_EQ(ran.out, "");
    EXPECT_THAT(ran.err, HasSubstr("over the limit of 16777216 bytes"));
}

TEST_F(SpoiltReplay, WithAStepThatNoRuleHasIsPrintedUpToThere) {
    auto bad = replay::from_bytes(std::as_bytes(std::span(whole_)))->replay;
    bad.entries.at(6).seat = model::opponent_of(bad.entries.at(6).seat);
    const Ran ran = run_on(content_of(bad), false);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr("entry 7: "));
    EXPECT_THAT(content_of(golden(".txt")), StartsWith(ran.out));
}

TEST(Replay, ThatIsNotThereIsNamed) {
    const Ran ran = run({.file = "/no/such/match.billiards"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_EQ(ran.err, "/no/such/match.billiards: No such file or directory\n");
}

}  // namespace
}  // namespace billiards::tools
