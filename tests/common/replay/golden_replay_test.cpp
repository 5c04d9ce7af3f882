// Holds this program to the matches that earlier engines have played: they must read and play for
// ever, and the one of this engine's version must come out again.
#include "common/replay/play.h"
#include "common/replay/replay_file.h"
#include "common/replay/verify.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

namespace billiards::replay {
namespace {

namespace fs = std::filesystem;

Replay read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    auto opened = from_bytes(std::as_bytes(std::span(text)));
    EXPECT_TRUE(opened.ok()) << file << ": " << opened.error().detail;
    EXPECT_FALSE(opened->damage) << file << ": " << opened->damage->detail;
    return std::move(opened).value().replay;
}

std::vector<fs::path> golden_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(GOLDEN_REPLAY_FOLDER)) {
        if (entry.path().extension() == ".billiards") files.push_back(entry.path());
    }
    return files;
}

TEST(GoldenReplays, ReadAndPlayForEver) {
    const auto files = golden_files();
    ASSERT_FALSE(files.empty());
    for (const fs::path& file : files) {
        const Replay replay = read(file);
        const auto end = play(replay, [](const Moment&) {});
        ASSERT_TRUE(end.ok()) << file << ": " << end.error().detail;
        EXPECT_EQ(end->stage, match::Stage::Over) << file;
        EXPECT_GT(end->shots_played, 10) << file;
    }
}

TEST(GoldenReplays, OfThisEngineComeOutAgain) {
    std::size_t of_this_engine = 0;
    for (const fs::path& file : golden_files()) {
        const Replay replay = read(file);
        if (replay.header.engine != kEngineVersion) continue;
        ++of_this_engine;
        const auto verified = verify(replay);
        EXPECT_TRUE(verified.ok()) << file << ": " << verified.error().detail
                                   << "\nShots are solved or judged otherwise now: raise "
                                      "kEngineVersion, and add a match with bin/record_replay";
    }
    EXPECT_GE(of_this_engine, 1U) << "add a match of engine " << kEngineVersion;
}

}  // namespace
}  // namespace billiards::replay
