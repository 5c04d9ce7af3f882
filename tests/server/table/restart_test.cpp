// Holds what a restart keeps: the match as it was stored, its players, and what they had played.
#include "common/protocol/codec_journal.h"
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using model::Seat;

class RestartTest : public MatchTest {
  protected:
    /// Everybody comes back under the names of the fixture.
    void all_come_back() {
        ada = come_back(token_of(ada));
        grace = come_back(token_of(grace));
        linus = come_back(token_of(linus));
        say(linus, client::Join{table, Role::Spectator});
    }
};

TEST_F(RestartTest, GoesOnWithTheSameMatchAtTheSameTable) {
    start_match();
    for (std::uint64_t shot_id = 1; shot_id <= 4; ++shot_id) {
        take_turn(shot_id);
        let_rest();
    }
    const match::MatchState before = state();
    const auto rows_before = last<told::TableSnapshot>(linus).row;
    restart();
    EXPECT_TRUE(left_alone.empty());
    EXPECT_EQ(lobby->stats().matches_running, 1U);
    all_come_back();
    EXPECT_EQ(state(), before);
    EXPECT_EQ(last<told::TableSnapshot>(ada).match, before);
    EXPECT_EQ(last<told::TableSnapshot>(ada).row.table, table);
    EXPECT_EQ(last<told::TableSnapshot>(ada).row.name, rows_before.name);
    EXPECT_EQ(last<told::TableSnapshot>(ada).your_seats, std::vector{Seat::First});
    EXPECT_EQ(last<told::TableSnapshot>(grace).your_seats, std::vector{Seat::Second});
    take_turn(5);
    EXPECT_EQ(count<told::ShotPlayed>(linus), 1U);
    EXPECT_EQ(last<told::ShotPlayed>(linus).after.shots_played, before.shots_played + 1);
}

TEST_F(RestartTest, TakesTheOutcomeFromTheJournalAndSolvesNothingAgain) {
    start_match();
    take_turn(1);
    let_rest();
    // A journal whose outcome no engine would give: a ball lies where it could not have come to
    // rest. What was stored is what was played.
    DurableWorld world = committer.durable();
    StoredEntry& stored = world.matches[0].entries.back();
    auto entry = protocol::decode_entry(stored.entry);
    ASSERT_TRUE(entry.ok());
    model::PlacedBall* eight = entry->final_layout->find(model::kEightBall);
    ASSERT_EQ(eight->place, model::Place::OnTable);
    eight->position_m += base::Vec2{0.0, 1e-4};
    const base::Vec2 moved = eight->position_m;
    stored.entry = protocol::encode_entry(*entry);

    lobby.reset();
    start();
    ASSERT_TRUE(lobby->restore(now, world.stored()).empty());
    all_come_back();
    EXPECT_EQ(state().layout.find(model::kEightBall)->position_m, moved);
}

TEST_F(RestartTest, AnswersAShotThatWasPlayedBeforeIt) {
    start_match();
    place_cue_ball();
    const Seat seat = state().to_act;
    const auto taken = shot(31);
    say(shooter(), taken);
    const auto played = last<told::ShotPlayed>(linus);
    restart();
    all_come_back();
    say(session_of(seat), taken);
    const auto answered = last<told::ShotPlayed>(session_of(seat));
    EXPECT_EQ(answered.record, played.record);
    EXPECT_EQ(answered.verdict, played.verdict);
    EXPECT_EQ(answered.after, played.after);
    EXPECT_EQ(answered.shot_id, 31U);
    EXPECT_EQ(count<told::ShotPlayed>(linus), 0U);
    EXPECT_EQ(lobby->stats().shots, 0U);
}

TEST_F(RestartTest, LosesAStepThatWasNotDurableAndNothingElse) {
    start_match();
    place_cue_ball();
    const match::MatchState before = state();
    disk_is_slow = true;
    say(shooter(), shot(1));
    disk_is_slow = false;
    restart();
    all_come_back();
    EXPECT_EQ(state(), before);
}

TEST_F(RestartTest, GivesTheClockBackInFullOnceAPlayerIsThere) {
    start_match();
    pass(55s);
    restart();
    pass(1h / 60 * 5);  // Nobody is there yet.
    const SessionId back = come_back(token_of(ada));
    const auto turn = last<told::TableSnapshot>(back).turn;
    EXPECT_EQ(turn.deadline_us, (now + 60s).time_since_epoch().count());
}

TEST_F(RestartTest, WaitsForItsPlayersOnlySoLong) {
    start_match();
    restart();
    pass(limits.empty_table_kept);
    EXPECT_EQ(lobby->stats().tables, 0U);
    EXPECT_TRUE(committer.durable().matches.empty());
}

TEST_F(RestartTest, GivesNoIdTwice) {
    start_match();
    const auto old_table = table;
    restart();
    const SessionId barbara = greet("Barbara");
    say(barbara, client::CreateTable{.name = "New", .settings = {}, .role = Role::BothSeats});
    EXPECT_GT(last<told::TableSnapshot>(barbara).row.table, old_table);
    say(barbara, client::Ready{});
    const DurableWorld world = committer.durable();
    ASSERT_EQ(world.matches.size(), 2U);
    EXPECT_EQ(world.players.size(), 4U);
}

TEST_F(RestartTest, SeatsOneClientOnBothSeatsAgain) {
    ada = greet("Ada");
    say(ada, client::CreateTable{.name = "Home", .settings = {}, .role = Role::BothSeats});
    say(ada, client::Ready{});
    restart();
    const SessionId back = come_back(token_of(ada));
    EXPECT_EQ(last<told::TableSnapshot>(back).your_seats, (std::vector{Seat::First, Seat::Second}));
}

TEST_F(RestartTest, ShowsTheMatchThatWasOverToThoseWhoHaveNotSeenItsEnd) {
    start_match();
    take_turn(1);
    const auto played = last<told::ShotPlayed>(linus);
    disk_is_slow = true;
    say(ada, client::Concede{});
    committer.complete();  // Durable, and nobody may have been told.
    disk_is_slow = false;
    restart();
    EXPECT_EQ(lobby->stats().tables, 1U);
    EXPECT_EQ(lobby->stats().matches_running, 0U);
    ada = come_back(token_of(ada));
    grace = come_back(token_of(grace));
    const auto snapshot = last<told::TableSnapshot>(ada);
    EXPECT_EQ(snapshot.your_seats, std::vector{Seat::First});
    EXPECT_EQ(snapshot.match->stage, match::Stage::Over);
    EXPECT_EQ(snapshot.match->winner, Seat::Second);
    EXPECT_EQ(snapshot.turn.deadline_us, std::nullopt);
    EXPECT_FALSE(snapshot.row.playing);
    const SessionId shot_by = played.seat == Seat::First ? ada : grace;
    say(shot_by, client::TakeShot{.turn = {1}, .shot_id = 1, .shot = {}, .call = {}});
    EXPECT_EQ(last<told::ShotPlayed>(shot_by).record, played.record);
    say(ada, client::Rematch{});
    say(grace, client::Rematch{});
    EXPECT_EQ(count<told::MatchStarted>(ada), 1U);
}

TEST_F(RestartTest, BringsBackATableWithoutAMatch) {
    match::Settings settings;
    settings.game = rules::Game::NineBall;
    seat_players(settings);
    const auto row = last<told::TableSnapshot>(grace).row;
    restart();
    ada = come_back(token_of(ada));
    grace = come_back(token_of(grace));
    EXPECT_EQ(last<told::Welcome>(grace).table, table);
    EXPECT_EQ(last<told::TableSnapshot>(grace).row, row);
    say(ada, client::Ready{});
    say(grace, client::Ready{});
    EXPECT_EQ(last<told::MatchStarted>(ada).state.settings, settings);
}

TEST_F(RestartTest, LeadsAPlayerBackToTheMatchThoughAnotherSeatIsStoredToo) {
    start_match();
    DurableWorld world = committer.durable();
    StoredTable left = world.tables[0];
    left.table = {table.value + 1};
    world.tables.push_back(left);
    world.highest.table = left.table.value;
    lobby.reset();
    start();
    ASSERT_TRUE(lobby->restore(now, world.stored()).empty());
    ada = come_back(token_of(ada));
    EXPECT_EQ(last<told::TableSnapshot>(ada).row.table, table);
    EXPECT_TRUE(last<told::TableSnapshot>(ada).match.has_value());
}

TEST_F(RestartTest, WritesNothingOfATableThatDidNotChange) {
    start_match();
    restart();
    EXPECT_EQ(committer.waiting(), 0U);
    disk_is_slow = true;
    come_back(token_of(ada));
    ASSERT_EQ(committer.waiting(), 1U);
    EXPECT_TRUE(std::holds_alternative<SavePlayer>(committer.next().front()));
    committer.complete();
    EXPECT_EQ(committer.waiting(), 0U);
}

TEST_F(RestartTest, DoesNotGiveTheNumberOfATableThatWasClosedAgain) {
    seat_players();
    disconnect(ada);
    disconnect(grace);
    disconnect(linus);
    pass(limits.empty_table_kept);
    EXPECT_EQ(committer.table(table), std::nullopt);
    restart();
    ada = come_back(token_of(ada));
    say(ada, client::CreateTable{.name = "New", .settings = {}, .role = Role::Player});
    EXPECT_GT(last<told::TableSnapshot>(ada).row.table, table);
}

TEST_F(RestartTest, FreesTheSeatsOfThoseWhoDoNotComeBackToATableWithoutAMatch) {
    seat_players();
    restart();
    pass(limits.absence_grace);
    EXPECT_EQ(committer.table(table)->seats[Seat::First], std::nullopt);
    EXPECT_EQ(committer.table(table)->seats[Seat::Second], std::nullopt);
}

TEST_F(RestartTest, LeavesAloneWhatDoesNotRefoldAndSaysWhy) {
    start_match();
    place_cue_ball();
    say(shooter(), shot(1));
    const DurableWorld good = committer.durable();
    const auto reason_of = [&](const auto& spoil) {
        DurableWorld world = good;
        spoil(world.matches[0]);
        lobby.reset();
        start();
        const auto reasons = lobby->restore(now, world.stored());
        EXPECT_EQ(lobby->stats().tables, 0U);
        return reasons.size() == 1 ? reasons[0] : std::string("restored");
    };
    using Live = DurableMatch;
    EXPECT_EQ(reason_of([](Live& live) { live.entries.erase(live.entries.begin()); }),
              "match 1: entry 2: expected sequence 1");
    EXPECT_NE(reason_of([](Live& live) {
                  std::swap(live.entries[0].entry, live.entries[1].entry);
              }).find("entry 1: refused"),
              std::string::npos);
    EXPECT_NE(
        reason_of([](Live& live) { live.entries[0].entry.command.resize(3); }).find("entry 1:"),
        std::string::npos);
    EXPECT_NE(reason_of([](Live& live) { live.match.settings.clear(); }).find("settings"),
              std::string::npos);
    EXPECT_EQ(reason_of([](Live& live) { live.match.players[Seat::Second] = {99}; }),
              "match 1: player 99 is not known");
    EXPECT_EQ(reason_of([](Live& live) { live.entries[1].entry.record.clear(); }),
              "match 1: entry 2: a shot without its outcome");
}

TEST_F(RestartTest, DoesWithoutAMatchThatIsOverAndDoesNotRefold) {
    start_match();
    take_turn(1);
    say(ada, client::Concede{});
    DurableWorld world = committer.durable();
    world.ended[0].entries.pop_back();
    lobby.reset();
    start();
    EXPECT_TRUE(lobby->restore(now, world.stored()).empty());
    ada = come_back(token_of(ada));
    EXPECT_EQ(last<told::TableSnapshot>(ada).match, std::nullopt);
}

}  // namespace
}  // namespace billiards::server
