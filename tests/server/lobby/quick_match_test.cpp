// Holds which table a quick match leads to.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

class QuickMatchTest : public GameTest {
  protected:
    protocol::TableId quick(SessionId session, rules::Game game = rules::Game::EightBall) {
        say(session, client::QuickMatch{game});
        return at(session);
    }
    protocol::TableId at(SessionId session) { return last<told::TableSnapshot>(session).row.table; }
    /// A table with one player, Ada, at it.
    protocol::TableId wait_at(client::CreateTable create) {
        ada = greet("Ada");
        say(ada, std::move(create));
        return at(ada);
    }

    SessionId ada;
};

TEST_F(QuickMatchTest, OpensATableWithTheGamesDefaultsWhereNobodyWaits) {
    const SessionId grace = greet("Grace");
    quick(grace, rules::Game::NineBall);
    match::Settings expected;
    expected.game = rules::Game::NineBall;
    EXPECT_EQ(last<told::TableSnapshot>(grace).row.settings, expected);
    EXPECT_FALSE(last<told::TableSnapshot>(grace).row.is_private);
    EXPECT_EQ(last<told::TableSnapshot>(grace).your_seats, std::vector{model::Seat::First});
}

TEST_F(QuickMatchTest, BringsTwoTogetherAndTheThirdToANewTable) {
    const auto first = quick(greet("Ada"));
    EXPECT_EQ(quick(greet("Grace")), first);
    EXPECT_NE(quick(greet("Linus")), first);
}

TEST_F(QuickMatchTest, TakesWhoHasWaitedLongest) {
    const auto first = wait_at({});
    wait_at({});
    EXPECT_EQ(quick(greet("Grace")), first);
}

TEST_F(QuickMatchTest, DoesNotMindHowLateSpectatorsSee) {
    match::Settings delayed;
    delayed.spectator_delay_s = 30.0;
    const auto first = wait_at({.name = {}, .settings = delayed});
    EXPECT_EQ(quick(greet("Grace")), first);
}

TEST_F(QuickMatchTest, LeavesOtherGamesAndOtherSettingsAlone) {
    match::Settings longer;
    longer.race_to = 9;
    const auto other = wait_at({.name = {}, .settings = longer});
    EXPECT_NE(quick(greet("Grace")), other);
    const auto eight_ball = wait_at({});
    EXPECT_NE(quick(greet("Linus"), rules::Game::NineBall), eight_ball);
}

TEST_F(QuickMatchTest, LeavesPrivateTablesAlone) {
    const auto hidden = wait_at({.name = {}, .settings = {}, .is_private = true});
    const auto locked = wait_at({.name = {}, .settings = {}, .passcode = "cue"});
    const auto found = quick(greet("Grace"));
    EXPECT_NE(found, hidden);
    EXPECT_NE(found, locked);
}

TEST_F(QuickMatchTest, LeavesATableAloneWhosePlayerIsAway) {
    const auto first = wait_at({});
    disconnect(ada);
    EXPECT_NE(quick(greet("Grace")), first);
}

TEST_F(QuickMatchTest, LeavesTablesAloneAtWhichNobodyOrOnlyASpectatorIs) {
    const auto first = wait_at({.name = {}, .settings = {}, .role = Role::Spectator});
    EXPECT_NE(quick(greet("Grace")), first);
}

TEST_F(QuickMatchTest, DoesNotLeadBackToWhereOneWasKicked) {
    const auto first = wait_at({});
    const SessionId grace = greet("Grace");
    quick(grace);
    say(ada, client::Kick{last<told::Welcome>(grace).name});
    EXPECT_NE(quick(grace), first);
    EXPECT_EQ(quick(greet("Linus")), first);
}

TEST_F(QuickMatchTest, IsRefusedWhileTheServerGoesDownAndBeyondTheLimitOfTables) {
    limits.max_tables = 1;
    start();
    wait_at({.name = {}, .settings = {}, .is_private = true});
    const SessionId grace = greet("Grace");
    say(grace, client::QuickMatch{});
    EXPECT_EQ(refusal(grace), RefusedCode::TooMany);
    lobby->shut_down(now);
    say(grace, client::QuickMatch{});
    EXPECT_EQ(refusal(grace), RefusedCode::ShuttingDown);
}

}  // namespace
}  // namespace billiards::server
