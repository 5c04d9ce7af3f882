// Holds playing and verifying against true matches and against matches that were tampered with.
#include "common/replay/verify.h"

#include "common/replay/play.h"
#include "tests/common/replay/bot_match.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace billiards::replay {
namespace {

using protocol::JournalEntry;
using testing::HasSubstr;
using testing::MatchesRegex;

const Replay& whole_match() {
    static const Replay replay = bot_match(race_to(2), 3);
    return replay;
}

/// The entry of the nth shot, from 1.
JournalEntry& shot_of(Replay& replay, int nth) {
    std::size_t index = 0;
    while (!replay.entries.at(index).record || --nth > 0) ++index;
    return replay.entries[index];
}

void ignore(const Moment&) {}

TEST(Play, VisitsEveryStepToTheEnd) {
    std::size_t visited = 0;
    std::optional<match::MatchState> last;
    const auto end = play(whole_match(), [&](const Moment& moment) {
        EXPECT_EQ(moment.index, visited++);
        EXPECT_EQ(&moment.entry, &whole_match().entries[moment.index]);
        EXPECT_TRUE(!last || moment.before == *last);
        last = moment.after;
    });
    ASSERT_TRUE(end.ok()) << end.error().detail;
    EXPECT_EQ(visited, whole_match().entries.size());
    EXPECT_EQ(*end, *last);
    EXPECT_EQ(end->stage, match::Stage::Over);
}

TEST(Play, NamesTheEntryThatDoesNotFollow) {
    Replay replay = whole_match();
    replay.entries.at(5).seat = model::opponent_of(replay.entries.at(5).seat);
    std::size_t visited = 0;
    const auto end = play(replay, [&](const Moment&) { ++visited; });
    ASSERT_FALSE(end.ok());
    EXPECT_EQ(end.error().code, FaultCode::Invalid);
    EXPECT_THAT(end.error().detail, HasSubstr("entry 6: "));
    EXPECT_EQ(visited, 5U);
}

TEST(Play, NeedsTheRecordOfEveryShot) {
    Replay replay = whole_match();
    shot_of(replay, 2).record.reset();
    EXPECT_THAT(play(replay, ignore).error().detail, HasSubstr("a shot without its record"));
}

TEST(Play, NeedsSettingsThatAMatchCanHave) {
    Replay replay = whole_match();
    replay.header.settings.race_to = 0;
    EXPECT_THAT(play(replay, ignore).error().detail, HasSubstr("race_to"));
}

TEST(Verify, HoldsForAMatchAsItWasPlayed) {
    const auto verified = verify(whole_match());
    EXPECT_TRUE(verified.ok()) << verified.error().detail;
}

TEST(Verify, LeavesAMatchOfAnotherEngineThatStillPlays) {
    Replay replay = whole_match();
    replay.header.engine = "0.9";
    const auto verified = verify(replay);
    ASSERT_FALSE(verified.ok());
    EXPECT_EQ(verified.error().code, NotVerifiedCode::OtherEngine);
    EXPECT_THAT(verified.error().detail, HasSubstr("played by engine 0.9, this is engine "));
    EXPECT_EQ(play(replay, ignore)->stage, match::Stage::Over);
}

struct Tampering {
    void (*tamper)(JournalEntry& shot);
    const char* told;
};

const Tampering kTamperings[] = {
    {[](JournalEntry& shot) { ++shot.record->hash; }, "the hash of its record is "},
    {[](JournalEntry& shot) { shot.record->duration_s += 1; }, "not the one that its hash is of"},
    {[](JournalEntry& shot) { shot.final_layout->balls[3].position_m.x += 1e-9; },
     "ball 3 comes to rest elsewhere"},
    {[](JournalEntry& shot) { shot.verdict->fouls.push_back(rules::Foul::BadPlacement); },
     "the ruling is another: fouls"},
    {[](JournalEntry& shot) { shot.record.reset(); }, "it has no such outcome"},
    {[](JournalEntry& shot) { ++std::get<match::TakeShot>(shot.command).turn.value; }, "refused: "},
    {[](JournalEntry& shot) { std::get<match::TakeShot>(shot.command).shot.angle_rad += 1e-9; },
     ""},
};

TEST(Verify, NamesTheFirstDifferenceInWords) {
    for (const Tampering& tampering : kTamperings) {
        Replay replay = whole_match();
        tampering.tamper(shot_of(replay, 7));
        const auto verified = verify(replay);
        ASSERT_FALSE(verified.ok()) << tampering.told;
        EXPECT_EQ(verified.error().code, NotVerifiedCode::Differs);
        EXPECT_THAT(verified.error().detail, MatchesRegex("shot 7 \\(entry [0-9]+\\): .*"));
        EXPECT_THAT(verified.error().detail, HasSubstr(tampering.told));
    }
}

TEST(Verify, SeesAnotherSeed) {
    Replay replay = whole_match();
    ++replay.header.seed;
    EXPECT_EQ(verify(replay).error().code, NotVerifiedCode::Differs);
}

}  // namespace
}  // namespace billiards::replay
