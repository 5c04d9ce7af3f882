// Holds what is kept against age, size and calendars that jump.
#include "tests/server/store/opened_store.h"

#include <SQLiteCpp/Database.h>

namespace billiards::server {
namespace {

using model::Seat;

class Sweep : public StoreTest {
  protected:
    Sweep() { open(); }

    Swept sweep(const Retention& retention) {
        const auto swept = store->sweep(retention);
        EXPECT_TRUE(swept.ok()) << swept.error().detail;
        return swept.ok() ? *swept : Swept{};
    }
    Swept sweep_days(std::int64_t days) { return sweep({.kept_s = days * kTestDay_s}); }
    std::size_t kept() { return store->ended_matches()->size(); }
    /// A match with so many entries of 9,000 bytes, which has ended.
    void play_long(std::uint64_t match, std::uint64_t entries) {
        std::vector<Write> writes{SaveMatch{some_match(match)}};
        for (std::uint64_t i = 1; i <= entries; ++i) {
            std::string record(9000, 'r');
            for (std::size_t at = 0; at < record.size(); ++at) {
                record[at] = static_cast<char>((at * at * 31 + i * at + at / 7) % 251);
            }
            writes.push_back(AppendEntry{{match}, some_entry(i, record)});
        }
        commit(writes);
        commit({finished(match)});
    }
    std::uint64_t bytes_in_use() {
        SQLite::Database database(file.string());
        const auto number = [&](const char* pragma) {
            return static_cast<std::uint64_t>(database.execAndGet(pragma).getInt64());
        };
        return (number("PRAGMA page_count") - number("PRAGMA freelist_count")) *
               number("PRAGMA page_size");
    }
};

TEST_F(Sweep, DropsTheJournalOfAnOldMatchAndKeepsItsResult) {
    play(1, 1, 2, won_by(Seat::First));
    pass(10 * kTestDay_s);
    play(2, 1, 2, won_by(Seat::First));
    EXPECT_EQ(sweep_days(10).matches, 0U);
    pass(1);
    EXPECT_EQ(sweep_days(10).matches, 1U);
    EXPECT_EQ(store->ended_matches()->at(0).match.match, MatchId{2});
    EXPECT_TRUE(whole_journal(*store, {1})->empty());
    EXPECT_EQ(store->find_match({1}).value(), std::nullopt);
    EXPECT_EQ(store->history({.asker = {1}, .at_most = 9})->size(), 2U);
}

TEST_F(Sweep, NeverDropsALiveMatch) {
    commit({SaveMatch{some_match(1)}, AppendEntry{{1}, some_entry(1)}});
    pass(1000 * kTestDay_s);
    EXPECT_EQ(sweep({.kept_s = 1, .most_bytes = 1}).entries, 0U);
    EXPECT_EQ(whole_journal(*store, {1})->size(), 1U);
}

TEST_F(Sweep, KeepsForEverWhereNothingIsSaid) {
    play(1, 1, 2, won_by(Seat::First));
    pass(100'000 * kTestDay_s);
    EXPECT_EQ(sweep({}).matches, 0U);
    EXPECT_EQ(kept(), 1U);
}

TEST_F(Sweep, DropsTheOldestFirstUntilTheFileIsSmallEnough) {
    for (std::uint64_t match = 1; match <= 8; ++match) play_long(match, 20);
    const std::uint64_t full = bytes_in_use();
    Swept swept{.is_done = false};
    while (!swept.is_done) swept = sweep({.most_bytes = full / 2});
    EXPECT_LE(bytes_in_use(), full / 2);
    const auto left = store->ended_matches().value();
    ASSERT_GE(left.size(), 2U);
    ASSERT_LT(left.size(), 8U);
    EXPECT_EQ(left.back().match.match, MatchId{8});
    EXPECT_EQ(left.front().match.match.value, 8 - left.size() + 1);
    EXPECT_EQ(sweep({.most_bytes = full / 2}).entries, 0U);
}

TEST_F(Sweep, DropsNoMoreAtOnceThanItMayAndHidesWhatIsHalfGone) {
    play_long(1, 25);
    pass(2 * kTestDay_s);
    const Retention retention{.kept_s = kTestDay_s, .most_bytes = 0, .entries_at_once = 10};
    EXPECT_EQ(sweep(retention).entries, 10U);
    EXPECT_EQ(kept(), 0U);
    EXPECT_EQ(store->find_match({1}).value(), std::nullopt);
    EXPECT_FALSE(sweep(retention).is_done);
    open();  // Killed meanwhile.
    const Swept last = sweep(retention);
    EXPECT_TRUE(last.is_done);
    EXPECT_EQ(last.entries, 5U);
    EXPECT_EQ(last.matches, 1U);
}

TEST_F(Sweep, GivesTheRoomBackToTheSystem) {
    for (std::uint64_t match = 1; match <= 8; ++match) play_long(match, 20);
    store.reset();  // Everything is in the file now.
    const auto before = std::filesystem::file_size(file);
    open();
    pass(2 * kTestDay_s);
    Swept swept{.is_done = false};
    while (!swept.is_done) swept = sweep_days(1);
    store.reset();
    EXPECT_LT(std::filesystem::file_size(file), before / 4);
}

TEST_F(Sweep, TakesNoJumpOfTheCalendarForAge) {
    play(1, 1, 2, won_by(Seat::First));
    times.calendar_s += 3000 * kTestDay_s;
    EXPECT_EQ(sweep_days(30).matches, 0U);
    open();  // A stop counts for one day at most.
    EXPECT_EQ(sweep_days(30).matches, 0U);
    times.calendar_s -= 6000 * kTestDay_s;
    open();
    EXPECT_EQ(sweep_days(30).matches, 0U);
    EXPECT_EQ(kept(), 1U);
}

TEST_F(Sweep, CountsTheTimeOfAStop) {
    play(1, 1, 2, won_by(Seat::First));
    store.reset();
    times = {.calendar_s = times.calendar_s + kTestDay_s / 2, .steady_s = 5};  // Started again.
    open();
    EXPECT_EQ(sweep({.kept_s = kTestDay_s / 2}).matches, 0U);
    pass(1);
    EXPECT_EQ(sweep({.kept_s = kTestDay_s / 2}).matches, 1U);
}

TEST_F(Sweep, ForgetsGuestsWhoWereNotSeenAndNeverFinishedAMatch) {
    std::vector<Write> writes;
    for (std::uint64_t id = 1; id <= 6; ++id) writes.push_back(SavePlayer{some_player(id)});
    StoredTable table = some_table(1);
    table.owner = {4};
    table.seats[Seat::Second] = PlayerId{5};
    writes.push_back(SaveTable{table});
    commit(writes);
    play(1, 1, 2, won_by(Seat::First));
    pass(31 * kTestDay_s);
    commit({SavePlayer{some_player(6)}});
    sweep({.kept_s = 30 * kTestDay_s});
    EXPECT_EQ(store->players()->size(), 6U);
    EXPECT_TRUE(sweep({.kept_s = 30 * kTestDay_s, .guests = true}).is_done);
    std::vector<std::uint64_t> left;
    const auto players = store->players().value();
    for (const StoredPlayer& player : players) left.push_back(player.player.value);
    EXPECT_EQ(left, (std::vector<std::uint64_t>{1, 2, 4, 5, 6}));
    EXPECT_EQ(store->highest_ids()->player, 6U);
}

}  // namespace
}  // namespace billiards::server
