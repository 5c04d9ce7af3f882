// Holds .billiards files against whole matches, and against every way in which a file can be bad.
#include "common/replay/replay_file.h"

#include "common/replay/block_chain.h"
#include "common/replay/play.h"
#include "common/replay/verify.h"
#include "tests/common/replay/bot_match.h"

#include <algorithm>
#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <utility>

namespace billiards::replay {
namespace {

using protocol::Bytes;
using testing::HasSubstr;

constexpr std::size_t kMajorAt = 8;
constexpr std::size_t kMinorAt = 10;

/// A few entries are enough for what concerns bytes.
const Replay& short_match() {
    static const Replay replay = bot_match(race_to(1), 5, 4);
    return replay;
}

Bytes bytes_of(const Replay& replay) {
    auto bytes = to_bytes(replay);
    EXPECT_TRUE(bytes.ok()) << bytes.error().detail;
    return std::move(bytes).value();
}

using Blocks = std::vector<std::pair<std::uint32_t, Bytes>>;

Blocks blocks_of(const Bytes& file) {
    Blocks blocks;
    BlockReader reader(file, kStartBytes);
    while (!reader.is_at_end()) {
        const auto block = reader.next().value();
        blocks.push_back({block.kind, {block.content.begin(), block.content.end()}});
    }
    return blocks;
}

/// A file whose checks are right, and whose content is what a test wants.
Bytes file_of(const Blocks& blocks, std::uint8_t minor = 0) {
    Bytes start = bytes_of(short_match());
    start.resize(kStartBytes);
    start[kMinorAt] = std::byte{minor};
    BlockWriter writer(start);
    for (const auto& [kind, content] : blocks) writer.add({kind, content});
    return writer.bytes();
}

void expect_refused(const Bytes& bytes, FaultCode code, const std::string& detail) {
    const auto opened = from_bytes(bytes);
    ASSERT_FALSE(opened.ok()) << detail;
    EXPECT_EQ(opened.error().code, code) << opened.error().detail;
    EXPECT_THAT(opened.error().detail, HasSubstr(detail));
}

void expect_not_written(const Replay& replay, const std::string& detail) {
    const auto refused = to_bytes(replay);
    ASSERT_FALSE(refused.ok()) << detail;
    EXPECT_EQ(refused.error().code, FaultCode::TooLarge);
    EXPECT_THAT(refused.error().detail, HasSubstr(detail));
}

void expect_start_of_short_match(const std::vector<protocol::JournalEntry>& entries) {
    const auto& all = short_match().entries;
    ASSERT_LE(entries.size(), all.size());
    EXPECT_TRUE(std::equal(entries.begin(), entries.end(), all.begin()));
}

TEST(ReplayFile, GivesBackAWholeMatchOfEachGame) {
    for (const rules::Game game : {rules::Game::EightBall, rules::Game::NineBall,
                                   rules::Game::TenBall, rules::Game::StraightPool}) {
        SCOPED_TRACE(static_cast<int>(game));
        match::Settings settings = race_to(game == rules::Game::StraightPool ? 1 : 2);
        settings.game = game;
        settings.options.target_points = 20;
        const Replay replay = bot_match(settings, 11);
        const auto opened = from_bytes(bytes_of(replay));
        ASSERT_TRUE(opened.ok()) << opened.error().detail;
        EXPECT_FALSE(opened->damage);
        EXPECT_EQ(opened->replay, replay);
        EXPECT_EQ(play(opened->replay, [](const Moment&) {})->stage, match::Stage::Over);
        EXPECT_TRUE(verify(opened->replay).ok());
    }
}

TEST(ReplayFile, CutAnywhereIsTruncatedAndOpensUpToThere) {
    const Bytes whole = bytes_of(short_match());
    std::size_t opened_files = 0;
    for (std::size_t size = 1; size < whole.size(); ++size) {
        SCOPED_TRACE(size);
        const auto opened = from_bytes(std::span(whole).first(size));
        const auto fault = opened ? opened->damage : opened.error();
        ASSERT_TRUE(fault);
        ASSERT_EQ(fault->code, FaultCode::Truncated);
        if (!opened) continue;
        ++opened_files;
        expect_start_of_short_match(opened->replay.entries);
    }
    EXPECT_GT(opened_files, whole.size() / 2);
}

TEST(ReplayFile, WithAnyByteChangedIsNeverTakenForWhole) {
    const Bytes whole = bytes_of(short_match());
    for (std::size_t at = 0; at < whole.size(); ++at) {
        SCOPED_TRACE(at);
        Bytes bytes = whole;
        bytes[at] ^= std::byte{0x40};
        const auto opened = from_bytes(bytes);
        const auto fault = opened ? opened->damage : opened.error();
        ASSERT_TRUE(fault);
        ASSERT_EQ(fault->code, at < kMajorAt   ? FaultCode::NotAReplay
                               : at < kMinorAt ? FaultCode::Newer
                                               : FaultCode::Edited);
        if (opened) expect_start_of_short_match(opened->replay.entries);
    }
}

TEST(ReplayFile, SaysWhereItWasChanged) {
    Bytes bytes = bytes_of(short_match());
    const std::size_t end = bytes.size() - 24;
    bytes.back() ^= std::byte{1};
    const auto opened = from_bytes(bytes);
    ASSERT_TRUE(opened.ok());
    EXPECT_EQ(opened->replay, short_match());
    EXPECT_THAT(opened->damage->detail, HasSubstr("byte " + std::to_string(end)));
}

TEST(ReplayFile, WithSomethingBehindItsEndWasEdited) {
    Bytes bytes = bytes_of(short_match());
    bytes.push_back(std::byte{0});
    const auto opened = from_bytes(bytes);
    ASSERT_TRUE(opened.ok());
    EXPECT_EQ(opened->replay, short_match());
    EXPECT_EQ(opened->damage->code, FaultCode::Edited);
}

TEST(ReplayFile, OfAnotherKindIsNoReplay) {
    expect_refused({}, FaultCode::NotAReplay, "no .billiards file");
    expect_refused(Bytes(1000, std::byte{'x'}), FaultCode::NotAReplay, "no .billiards file");
}

TEST(ReplayFile, OfANewerVersionIsRefusedByItsNumber) {
    Bytes bytes = bytes_of(short_match());
    bytes[kMajorAt] = std::byte{2};
    expect_refused(bytes, FaultCode::Newer, "its format is 2.0, this program reads up to 1");
}

TEST(ReplayFile, OfANewerMinorVersionIsReadWithoutWhatIsNew) {
    Blocks blocks = blocks_of(bytes_of(short_match()));
    blocks.insert(blocks.begin() + 2, {99, Bytes(5)});
    const auto opened = from_bytes(file_of(blocks, 1));
    ASSERT_TRUE(opened.ok()) << opened.error().detail;
    EXPECT_FALSE(opened->damage);
    EXPECT_EQ(opened->replay, short_match());
    expect_refused(file_of(blocks, 0), FaultCode::Invalid, "no known kind");
}

TEST(ReplayFile, WithoutAHeaderOrWithoutSenseIsInvalid) {
    const Blocks blocks = blocks_of(bytes_of(short_match()));
    expect_refused(file_of({blocks.back()}), FaultCode::Invalid, "header");
    expect_refused(file_of({{1, Bytes(3)}}), FaultCode::Invalid, "header");
    expect_refused(file_of({blocks[0], {2, Bytes(3)}}), FaultCode::Invalid, "entry 1: ");
    const std::array<Bytes, 4> no_command{Bytes(5)};
    expect_refused(file_of({blocks[0], {2, joined(no_command)}}), FaultCode::Invalid,
                   "entry 1: cannot be read: ");
    expect_refused(file_of({blocks[0], blocks[1], {2, {}}}), FaultCode::Invalid, "entry 2: ");
}

TEST(ReplayFile, WithANameThatIsNotFitToBeShownIsInvalid) {
    Replay replay = short_match();
    replay.header.players[model::Seat::Second] = "Gr\x1b[2Jace";
    expect_refused(bytes_of(replay), FaultCode::Invalid, "name");
    replay = short_match();
    replay.header.table = std::string(41, 'x');
    expect_refused(bytes_of(replay), FaultCode::Invalid, "name");
    replay = short_match();
    replay.header.started_s = -1;
    expect_refused(bytes_of(replay), FaultCode::Invalid, "time");
}

TEST(ReplayFile, Over16MiBIsRefused) {
    Bytes bytes = bytes_of(short_match());
    bytes.resize(kMaxFileBytes + 1);
    expect_refused(bytes, FaultCode::TooLarge, "16777216 bytes");
}

TEST(ReplayFile, HasAtMost5000Shots) {
    Replay replay = short_match();
    protocol::JournalEntry shot;
    shot.command = match::TakeShot{};
    replay.entries.assign(kMaxShots, shot);
    const Bytes most = bytes_of(replay);
    EXPECT_EQ(from_bytes(most)->replay.entries.size(), kMaxShots);
    replay.entries.push_back(shot);
    expect_not_written(replay, "5000 shots");
    Blocks blocks = blocks_of(most);
    blocks.insert(blocks.begin() + 1, Blocks::value_type(blocks[1]));
    expect_refused(file_of(blocks), FaultCode::TooLarge, "5000 shots");
}

TEST(ReplayFile, HasAtMost20000Entries) {
    Replay replay = short_match();
    replay.entries.assign(kMaxEntries + 1, protocol::JournalEntry{});
    expect_not_written(replay, "20000 entries");
}

/// A record that takes a megabyte and packs into nearly nothing.
protocol::JournalEntry large_shot() {
    protocol::JournalEntry shot;
    shot.record.emplace();
    shot.record->timeline.tracks.resize(1);
    shot.record->timeline.tracks[0].radius_m = 0.03;
    shot.record->timeline.tracks[0].segments.resize(40'000);
    return shot;
}

TEST(ReplayFile, TakesNoMoreThanItsLimitHoweverWellItIsPacked) {
    Replay replay = short_match();
    replay.entries.assign(1, large_shot());
    const std::size_t unpacked = protocol::encode_entry(large_shot()).record.size();
    const Blocks one = blocks_of(bytes_of(replay));
    Blocks many(kMaxUnpackedBytes / unpacked + 1, one[1]);
    many.insert(many.begin(), one[0]);
    const Bytes file = file_of(many);
    EXPECT_LT(file.size(), kMaxFileBytes);
    expect_refused(file, FaultCode::TooLarge, "bytes once unpacked");
}

TEST(ReplayFile, HasAtMost22Balls) {
    Replay replay = short_match();
    protocol::JournalEntry& shot = replay.entries.back();
    shot.final_layout.emplace();
    for (std::uint8_t number = 0; number < model::kMaxBalls; ++number) {
        shot.final_layout->balls.push_back({{number}, model::Place::OnTable, {}});
    }
    EXPECT_TRUE(from_bytes(bytes_of(replay)).ok());
    shot.final_layout->balls.push_back({{22}, model::Place::OnTable, {}});
    expect_refused(bytes_of(replay), FaultCode::Invalid, "entry 4: ");
}

}  // namespace
}  // namespace billiards::replay
