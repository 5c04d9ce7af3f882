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

TEST_F(SpoiltReplay, OfAnOldEngineIsPrintedButNotVerified) {
    auto old = replay::from_bytes(std::as_bytes(std::span(whole_)))->replay;
    old.header.engine = "0.9";
    const Bytes bytes = replay::to_bytes(old).value();
    const std::string content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EXPECT_EQ(run_on(content, false).exit_code, 0);
    const Ran ran = run_on(content, true);
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
    const Bytes bytes = replay::to_bytes(bad).value();
    const Ran ran =
        run_on(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), false);
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
