// Holds what lies between two matches: the rematch, and what the next one is played by.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using model::Seat;

class RematchTest : public MatchTest {
  protected:
    std::string detail(SessionId session) { return last<told::Refused>(session).detail; }
};

TEST_F(RematchTest, StartsTheNextMatchWhenBothWantIt) {
    start_match();
    say(ada, client::Concede{});
    say(ada, client::Rematch{});
    EXPECT_TRUE(last<told::SeatChanged>(grace).seats[Seat::First].ready);
    EXPECT_EQ(count<told::MatchStarted>(linus), 1U);
    say(grace, client::Rematch{});
    EXPECT_EQ(count<told::MatchStarted>(linus), 2U);
    EXPECT_EQ(last<told::MatchStarted>(linus).state.shots_played, 0);
}

TEST_F(RematchTest, IsRefusedBeforeAndDuringAMatch) {
    seat_players();
    say(ada, client::Rematch{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotAllowed);
    say(ada, client::Ready{});
    say(grace, client::Ready{});
    say(ada, client::Rematch{});
    EXPECT_EQ(refusal(ada), RefusedCode::MatchRunning);
}

TEST_F(RematchTest, IsRefusedWhereAnotherHasTakenTheOpponentsSeat) {
    start_match();
    say(grace, client::Concede{});
    say(grace, client::Leave{});
    say(ada, client::Rematch{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotAllowed);
    say(linus, client::Leave{});
    say(linus, client::Join{table, Role::Player});
    say(ada, client::Rematch{});
    EXPECT_EQ(refusal(ada), RefusedCode::NotAllowed);
    EXPECT_EQ(detail(ada), "the opponent of that match has left");
    say(ada, client::Ready{});
    say(linus, client::Ready{});
    EXPECT_EQ(count<told::MatchStarted>(linus), 2U);
}

TEST_F(RematchTest, IsForTheSameTwoAfterARestartToo) {
    start_match();
    take_turn(1);
    say(ada, client::Concede{});
    restart();
    ada = come_back(token_of(ada));
    grace = come_back(token_of(grace));
    say(ada, client::Rematch{});
    say(grace, client::Rematch{});
    EXPECT_EQ(count<told::MatchStarted>(ada), 1U);
}

}  // namespace
}  // namespace billiards::server
