// Holds the order of things: first the disk, then the world; and what a failing disk undoes.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using model::Seat;

class DurabilityTest : public MatchTest {
  protected:
    template <class Kept>
    std::size_t writes_waiting() {
        std::size_t found = 0;
        for (const Write& write : committer.next()) {
            found += std::holds_alternative<Kept>(write) ? 1U : 0U;
        }
        return found;
    }
};

TEST_F(DurabilityTest, StartsAMatchOnlyOnceItIsDurable) {
    seat_players();
    say(ada, client::Ready{});
    disk_is_slow = true;
    say(grace, client::Ready{});
    EXPECT_EQ(count<told::MatchStarted>(ada), 0U);
    EXPECT_EQ(writes_waiting<SaveMatch>(), 1U);
    committer.complete();
    EXPECT_EQ(count<told::MatchStarted>(ada), 1U);
}

TEST_F(DurabilityTest, AsksForReadyAgainWhereTheMatchCouldNotBeStored) {
    seat_players();
    say(ada, client::Ready{});
    disk_is_slow = true;
    say(grace, client::Ready{});
    committer.fail();
    for (const SessionId session : {ada, grace, linus}) {
        EXPECT_EQ(last<told::Refused>(session).code, RefusedCode::StorageFailed);
        EXPECT_FALSE(last<told::SeatChanged>(session).seats[Seat::First].ready);
    }
    disk_is_slow = false;
    say(ada, client::Ready{});
    say(grace, client::Ready{});
    EXPECT_EQ(count<told::MatchStarted>(ada), 1U);
}

TEST_F(DurabilityTest, KeepsTheSeatOfWhoIsLostWhileTheMatchIsBeingStored) {
    seat_players();
    say(ada, client::Ready{});
    disk_is_slow = true;
    say(grace, client::Ready{});
    disconnect(grace);
    say(linus, client::Leave{});
    say(linus, client::Join{table, Role::Player});
    EXPECT_EQ(refusal(linus), RefusedCode::SeatTaken);
    say(ada, client::Leave{});
    EXPECT_EQ(refusal(ada), RefusedCode::MatchRunning);
    committer.complete_all();
    EXPECT_EQ(count<told::MatchStarted>(ada), 1U);
}

TEST_F(DurabilityTest, StartsAMatchOnceThoughAPlayerComesBackReadyMeanwhile) {
    seat_players();
    say(ada, client::Ready{});
    disk_is_slow = true;
    say(grace, client::Ready{});
    disconnect(grace);
    const SessionId back = come_back(token_of(grace));
    ASSERT_EQ(committer.waiting(), 2U);  // The match, then the token.
    say(ada, client::Ready{});
    EXPECT_EQ(refusal(ada), RefusedCode::MatchRunning);
    committer.complete_all();
    EXPECT_EQ(last<told::TableSnapshot>(back).match, last<told::MatchStarted>(ada).state);
    EXPECT_EQ(committer.durable().matches.size(), 1U);
}

TEST_F(DurabilityTest, StoresASeatThatADiskDidNotTakeOnceTheDiskWorksAgain) {
    seat_players();
    disk_is_slow = true;
    say(grace, client::Leave{});
    committer.fail();
    EXPECT_NE(committer.table(table)->seats[Seat::Second], std::nullopt);
    pass(0s);
    EXPECT_EQ(committer.waiting(), 0U);  // Not while the disk fails.
    disk_is_slow = false;
    greet("Hedy");
    pass(0s);
    EXPECT_EQ(committer.table(table)->seats[Seat::Second], std::nullopt);
    pass(0s);
    EXPECT_EQ(committer.waiting(), 0U);
}

TEST_F(DurabilityTest, FreesASeatWhosePlayerWasLostBeforeTheMatchFailedToBeStored) {
    seat_players();
    say(ada, client::Ready{});
    disk_is_slow = true;
    say(grace, client::Ready{});
    disconnect(grace);
    disconnect(ada);
    committer.fail();
    disk_is_slow = false;
    pass(limits.absence_grace + committer.takes);
    const SessionId hedy = greet("Hedy");
    say(hedy, client::ListTables{});
    const auto row = last<told::TableList>(hedy).tables.front();
    EXPECT_FALSE(row.seats[Seat::First].taken);
    EXPECT_FALSE(row.seats[Seat::Second].taken);
}

TEST_F(DurabilityTest, ShowsAShotOnlyOnceItIsDurable) {
    start_match();
    place_cue_ball();
    disk_is_slow = true;
    say(shooter(), shot(1));
    pass(1s);
    for (const SessionId session : {ada, grace, linus}) {
        EXPECT_EQ(count<told::ShotPlayed>(session), 0U);
    }
    EXPECT_EQ(writes_waiting<AppendEntry>(), 1U);
    committer.takes = 1s;
    committer.complete();
    const auto played = last<told::ShotPlayed>(linus);
    EXPECT_EQ(played.commit_us, 1'000'000U);
    EXPECT_EQ(played.struck_us, now.time_since_epoch().count());
}

TEST_F(DurabilityTest, UndoesAStepThatCouldNotBeStoredAndTellsEveryone) {
    start_match();
    place_cue_ball();
    const match::MatchState before = state();
    const SessionId who = shooter();
    disk_is_slow = true;
    say(who, shot(1));
    committer.fail();
    EXPECT_EQ(refusal(who), RefusedCode::StorageFailed);
    EXPECT_EQ(last<told::Refused>(linus).code, RefusedCode::StorageFailed);
    EXPECT_EQ(last<told::Refused>(linus).in_reply_to, 0U);
    EXPECT_TRUE(lobby->stats().storage_failing);
    EXPECT_EQ(lobby->stats().shots, 0U);

    disk_is_slow = false;
    const SessionId late = greet("Late");
    say(late, client::Join{table, Role::Spectator});
    EXPECT_EQ(last<told::TableSnapshot>(late).match, before);
    say(who, shot(1));  // The same shot again: it was never played.
    EXPECT_EQ(count<told::ShotPlayed>(linus), 1U);
    EXPECT_FALSE(lobby->stats().storage_failing);
}

TEST_F(DurabilityTest, GivesTheClockBackWhereTheDiskFailed) {
    start_match();
    place_cue_ball();
    pass(50s);
    disk_is_slow = true;
    say(shooter(), shot(1));
    committer.fail();
    const auto opened = last<told::TurnOpened>(linus);
    const auto allowed = base::duration_of(match::Settings{}.break_shot_clock_s);
    EXPECT_EQ(opened.turn.deadline_us,
              (now + committer.takes + allowed).time_since_epoch().count());
}

TEST_F(DurabilityTest, HasOneStepOnItsWayAndTheOthersWaitInOrder) {
    start_match();
    disk_is_slow = true;
    const SessionId who = shooter();
    place_cue_ball();
    say(who, shot(1));
    say(who, shot(1));
    EXPECT_EQ(committer.waiting(), 1U);
    committer.complete();
    EXPECT_EQ(count<told::CueBallPlaced>(linus), 1U);
    EXPECT_EQ(count<told::ShotPlayed>(linus), 0U);
    EXPECT_EQ(committer.waiting(), 1U);
    committer.complete();
    EXPECT_EQ(count<told::ShotPlayed>(linus), 1U);
    EXPECT_EQ(count<told::ShotPlayed>(who), 2U);  // The repeat was answered.
    EXPECT_EQ(committer.waiting(), 0U);
}

TEST_F(DurabilityTest, PlaysAShotThatWaitedThoughItsPlayerIsGoneMeanwhile) {
    start_match();
    disk_is_slow = true;
    const SessionId who = shooter();
    place_cue_ball();
    say(who, shot(1));
    disconnect(who);
    committer.complete_all();
    EXPECT_EQ(count<told::ShotPlayed>(linus), 1U);
}

TEST_F(DurabilityTest, RefusesWhatDependedOnAStepThatFailed) {
    start_match();
    disk_is_slow = true;
    const SessionId who = shooter();
    place_cue_ball();
    say(who, shot(1));
    committer.fail();
    EXPECT_EQ(match_refusal(who), match::RefusalCode::CueBallNotPlaced);
    EXPECT_EQ(committer.waiting(), 0U);
}

TEST_F(DurabilityTest, LetsOnlySoManyCommandsWait) {
    start_match();
    disk_is_slow = true;
    const SessionId who = shooter();
    place_cue_ball();
    for (std::size_t i = 0; i < limits.queued_commands; ++i) {
        say(who, shot(i));
        EXPECT_EQ(refusal(who), std::nullopt);
    }
    say(who, shot(99));
    EXPECT_EQ(refusal(who), RefusedCode::TooMany);
}

TEST_F(DurabilityTest, WaitsForNoTimeWhileTheDiskHasTheStep) {
    start_match();
    place_cue_ball();
    disk_is_slow = true;
    say(shooter(), shot(1));
    pass(59s);  // Of the idle limit's 60; the break's clock of 60 s runs out meanwhile.
    keep_alive();
    pass(30s);
    EXPECT_EQ(committer.waiting(), 1U);
    committer.complete();
    EXPECT_EQ(count<told::ShotPlayed>(linus), 1U);
    EXPECT_EQ(count<told::MatchMoved>(linus), 0U);
}

TEST_F(DurabilityTest, FinishesAMatchInTheSameWriteAsItsLastEntry) {
    start_match();
    disk_is_slow = true;
    say(ada, client::Concede{});
    EXPECT_EQ(writes_waiting<AppendEntry>(), 1U);
    EXPECT_EQ(writes_waiting<FinishMatch>(), 1U);
    EXPECT_EQ(count<told::MatchOver>(linus), 0U);
    committer.complete();
    EXPECT_EQ(count<told::MatchOver>(linus), 1U);
    EXPECT_TRUE(committer.durable().matches.empty());
}

TEST_F(DurabilityTest, WritesNothingForAimsChatAndPings) {
    start_match();
    disk_is_slow = true;
    say(ada, client::Ping{});
    say(ada, client::Chat{"hello"});
    say(shooter(), client::Aim{.turn = state().turn, .shot = {}});
    EXPECT_EQ(committer.waiting(), 0U);
}

}  // namespace
}  // namespace billiards::server
