// Holds what a player finds who comes back, or comes late.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using model::Seat;

class ReturnTest : public MatchTest {};

TEST_F(ReturnTest, KeepsTheSeatOfALostConnection) {
    start_match();
    disconnect(ada);
    EXPECT_FALSE(last<told::SeatChanged>(grace).seats[Seat::First].connected);
    EXPECT_TRUE(last<told::SeatChanged>(grace).seats[Seat::First].taken);

    const SessionId back = come_back(token_of(ada));
    EXPECT_EQ(last<told::Welcome>(back).table, table);
    EXPECT_EQ(last<told::TableSnapshot>(back).your_seats, std::vector{Seat::First});
    EXPECT_EQ(last<told::TableSnapshot>(back).match, state());
    EXPECT_TRUE(last<told::SeatChanged>(grace).seats[Seat::First].connected);
}

TEST_F(ReturnTest, TakesTheSeatOverFromAConnectionThatIsOnlyHalfGone) {
    start_match();
    const SessionId back = come_back(token_of(ada));
    EXPECT_TRUE(outbox.is_closed(ada));
    ada = back;
    take_turn(1);
    EXPECT_EQ(count<told::ShotPlayed>(back), 1U);
}

TEST_F(ReturnTest, AnswersTheShotThatIsRepeatedAfterAReconnect) {
    start_match();
    place_cue_ball();
    const SessionId who = shooter();
    const auto taken = shot(9);
    say(who, taken);
    const auto frame = outbox.frames<told::ShotPlayed>(linus).back();
    disconnect(who);
    const SessionId back = come_back(token_of(who));
    say(back, taken);
    EXPECT_EQ(outbox.frames<told::ShotPlayed>(back), std::vector{frame});
    EXPECT_EQ(lobby->stats().shots, 1U);
}

TEST_F(ReturnTest, BringsASpectatorBackToTheStand) {
    start_match();
    disconnect(linus);
    const SessionId back = come_back(token_of(linus));
    EXPECT_EQ(last<told::Welcome>(back).table, table);
    EXPECT_TRUE(last<told::TableSnapshot>(back).your_seats.empty());
    linus = back;
    take_turn(1);
    EXPECT_EQ(count<told::ShotPlayed>(back), 1U);
}

TEST_F(ReturnTest, BringsWhoLeftBackToTheLobby) {
    start_match();
    say(linus, client::Leave{});
    disconnect(linus);
    EXPECT_EQ(last<told::Welcome>(come_back(token_of(linus))).table, std::nullopt);
}

TEST_F(ReturnTest, ShowsALatecomerTheShotThatIsStillRolling) {
    start_match();
    take_turn(1);
    const auto played = last<told::ShotPlayed>(linus);
    pass(base::duration_of(played.record.duration_s / 2));
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    const auto snapshot = last<told::TableSnapshot>(late);
    EXPECT_EQ(snapshot.rolling, played);
    EXPECT_EQ(snapshot.match, played.after);
    EXPECT_EQ(snapshot.turn, played.turn);
    EXPECT_EQ(snapshot.server_time_us, now.time_since_epoch().count());
    EXPECT_GT(snapshot.server_time_us, played.struck_us);
}

TEST_F(ReturnTest, ShowsALatecomerNoShotThatHasComeToRest) {
    start_match();
    take_turn(1);
    let_rest();
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(late).rolling, std::nullopt);
    EXPECT_EQ(last<told::TableSnapshot>(late).match, state());
}

TEST_F(ReturnTest, ShowsALatecomerNoShotThatEveryoneHasSeenAlready) {
    start_match();
    take_turn(1);
    say(ada, client::Seen{last<told::ShotPlayed>(ada).sequence});
    say(grace, client::Seen{last<told::ShotPlayed>(grace).sequence});
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(late).rolling, std::nullopt);
}

TEST_F(ReturnTest, ShowsALatecomerTheLastShotOfAMatchOnlyUntilItRests) {
    start_match();
    take_turn(1);
    say(ada, client::Concede{});
    const SessionId in_time = greet("Early");
    say(in_time, client::Join{table, Role::Spectator});
    EXPECT_TRUE(last<told::TableSnapshot>(in_time).rolling.has_value());
    let_rest();
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(late).rolling, std::nullopt);
}

TEST_F(ReturnTest, ShowsALatecomerNoShotOfTheMatchBefore) {
    start_match();
    take_turn(1);
    say(ada, client::Concede{});
    say(ada, client::Ready{});
    say(grace, client::Ready{});
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(late).rolling, std::nullopt);
}

TEST_F(ReturnTest, BringsASpectatorToTheLobbyWhereTheStandIsFull) {
    limits.max_spectators_per_table = 1;
    start();
    start_match();
    disconnect(linus);
    say(greet("Quick"), client::Join{table, Role::Spectator});
    const SessionId back = come_back(token_of(linus));
    EXPECT_EQ(last<told::Welcome>(back).table, std::nullopt);
    say(back, client::ListTables{});
    EXPECT_EQ(refusal(back), std::nullopt);
}

TEST_F(ReturnTest, KeepsATableWhoseStepIsOnItsWayToTheDisk) {
    start_match();
    place_cue_ball();
    disk_is_slow = true;
    say(shooter(), shot(1));
    disconnect(ada);
    disconnect(grace);
    for (base::Duration away{}; away <= limits.empty_table_kept; away += 30s) {
        say(linus, client::Ping{});
        pass(30s);
    }
    say(linus, client::Leave{});  // Its announcement wakes the table.
    pass(limits.spectator_count_every);
    EXPECT_EQ(lobby->stats().tables, 1U);
    committer.complete();
    EXPECT_EQ(committer.journal({1}).size(), 2U);
    pass(1us);
    EXPECT_EQ(lobby->stats().tables, 0U);
}

TEST_F(ReturnTest, EndsAMatchThatBothHaveLeftForTooLong) {
    start_match();
    disconnect(ada);
    disconnect(grace);
    for (base::Duration away{}; away < limits.empty_table_kept; away += 30s) {
        EXPECT_EQ(lobby->stats().tables, 1U);
        say(linus, client::Ping{});
        pass(30s);
    }
    EXPECT_EQ(last<told::Notice>(linus).code, told::NoticeCode::TableClosed);
    EXPECT_EQ(lobby->stats().tables, 0U);
    EXPECT_TRUE(committer.durable().matches.empty());
    EXPECT_EQ(last<told::Welcome>(come_back(token_of(ada))).table, std::nullopt);
}

}  // namespace
}  // namespace billiards::server
