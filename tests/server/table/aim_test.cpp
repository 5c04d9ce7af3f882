// Holds aims: shown to the others, never stored, slowed down, and dropped where they mean nothing.
#include "tests/server/support/game_test.h"

#include <cmath>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

class AimTest : public MatchTest {
  protected:
    void aim_at_60_hz(SessionId session, base::Duration length) {
        for (base::Duration spent{}; spent < length; spent += 16'667us) {
            say(session, client::Aim{.turn = state().turn, .shot = {}});
            pass(16'667us);
        }
    }
};

TEST_F(AimTest, IsShownToTheOthersAsSomethingThatMayBeReplaced) {
    start_match();
    say(shooter(), client::Aim{.turn = state().turn, .shot = {.angle_rad = 1.25}});
    for (const SessionId session : {other(), linus}) {
        const Told shown = outbox.told(session).back();
        ASSERT_TRUE(std::holds_alternative<told::AimShown>(shown.message));
        EXPECT_EQ(shown.delivery, Delivery::LatestWins);
        EXPECT_EQ(std::get<told::AimShown>(shown.message).shot.angle_rad, 1.25);
    }
    EXPECT_EQ(count<told::AimShown>(shooter()), 0U);
    EXPECT_EQ(committer.waiting(), 0U);
}

TEST_F(AimTest, IsSlowedDownToItsRates) {
    start_match();
    aim_at_60_hz(shooter(), 10s);
    EXPECT_NEAR(static_cast<double>(count<told::AimShown>(other())),
                10.0 * limits.aim_per_s_to_players, 2.0);
    EXPECT_NEAR(static_cast<double>(count<told::AimShown>(linus)),
                10.0 * limits.aim_per_s_to_spectators, 2.0);
}

TEST_F(AimTest, IsDroppedOutOfTurnOutOfDateOrOutOfItsMind) {
    start_match();
    say(other(), client::Aim{.turn = state().turn, .shot = {}});
    say(shooter(), client::Aim{.turn = {state().turn.value + 1}, .shot = {}});
    say(shooter(), client::Aim{.turn = state().turn, .shot = {.angle_rad = std::nan("")}});
    EXPECT_EQ(count<told::AimShown>(linus), 0U);
    EXPECT_EQ(count<told::Refused>(shooter()) + count<told::Refused>(other()), 0U);
}

TEST_F(AimTest, IsDroppedWhileTheBallsRoll) {
    start_match();
    take_turn(1);
    say(shooter(), client::Aim{.turn = state().turn, .shot = {}});
    EXPECT_EQ(count<told::AimShown>(linus), 0U);
}

}  // namespace
}  // namespace billiards::server
