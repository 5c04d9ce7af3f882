// Holds practice over a table: balls set down anywhere, and what was done taken back.
#include "tests/server/support/game_test.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

class PracticeTest : public MatchTest {
  protected:
    void start_practice() {
        ada = grace = linus = greet("Ada");
        client::CreateTable create{.name = "", .settings = {}, .role = Role::BothSeats};
        create.settings.game = rules::Game::Practice;
        say(ada, create);
        say(ada, client::Ready{});
        ASSERT_EQ(count<told::MatchStarted>(ada), 1U);
    }
    told::Move move() { return last<told::MatchMoved>(ada).move; }
    base::Vec2 where(model::BallId ball) { return state().layout.find(ball)->position_m; }
};

TEST_F(PracticeTest, SetsAnyBallDownTakesItBackAndRacksAgain) {
    start_practice();
    const base::Vec2 before = where(model::kEightBall);
    say(ada, client::PlaceBall{model::kEightBall, {0.2, 0.3}});
    EXPECT_EQ(move(), told::Move::Placing);
    EXPECT_EQ(where(model::kEightBall), (base::Vec2{0.2, 0.3}));
    say(ada, client::Undo{});
    EXPECT_EQ(move(), told::Move::Undoing);
    EXPECT_EQ(where(model::kEightBall), before);
    say(ada, client::Rerack{});
    EXPECT_EQ(move(), told::Move::Reracking);
}

TEST_F(PracticeTest, GoesBackToBeforeTheShotForAnotherTry) {
    start_practice();
    if (!state().layout.on_table(model::kCueBall)) place_cue_ball();
    const auto before = state().layout;
    say(ada, client::TakeShot{.turn = state().turn,
                              .shot_id = 1,
                              .shot = {.angle_rad = 0.0, .power = 0.5},
                              .call = {}});
    let_rest();
    EXPECT_NE(state().layout, before);
    say(ada, client::Repeat{});
    EXPECT_EQ(move(), told::Move::Repeating);
    EXPECT_EQ(state().layout, before);
}

TEST_F(PracticeTest, LimitsHowOftenBallsAreSetDown) {
    start_practice();
    for (int i = 0; i < limits.placements_per_10s; ++i) {
        say(ada, client::PlaceBall{model::kEightBall, {0.2, 0.01 * i}});
        EXPECT_EQ(refusal(ada), std::nullopt);
    }
    say(ada, client::PlaceBall{model::kEightBall, {0.1, 0.0}});
    EXPECT_EQ(refusal(ada), RefusedCode::TooMany);
}

TEST_F(PracticeTest, LimitsHowOftenIsShot) {
    start_practice();
    const client::TakeShot no_ball{.turn = {99}, .shot_id = 1, .shot = {}, .call = {}};
    for (int i = 0; i < limits.practice_shots_per_s; ++i) {
        say(ada, no_ball);
        EXPECT_EQ(match_refusal(ada), match::RefusalCode::StaleTurn);
    }
    say(ada, no_ball);
    EXPECT_EQ(refusal(ada), RefusedCode::TooMany);
    pass(base::Duration(1s) / limits.practice_shots_per_s);
    say(ada, no_ball);
    EXPECT_EQ(match_refusal(ada), match::RefusalCode::StaleTurn);
}

TEST_F(PracticeTest, LimitsHowOftenItIsRackedAgain) {
    start_practice();
    for (int i = 0; i < limits.practice_shots_per_s; ++i) {
        say(ada, client::Rerack{});
        EXPECT_EQ(refusal(ada), std::nullopt);
    }
    say(ada, client::Rerack{});
    EXPECT_EQ(refusal(ada), RefusedCode::TooMany);
}

TEST_F(PracticeTest, CanOnlyBeEndedOnceItsJournalIsFull) {
    limits.entries_per_match = 2;
    start();
    start_practice();
    for (int i = 0; i < 2; ++i) say(ada, client::PlaceBall{model::kEightBall, {0.2, 0.1 * i}});
    EXPECT_EQ(refusal(ada), std::nullopt);
    say(ada, client::Undo{});
    EXPECT_EQ(refusal(ada), RefusedCode::TooMany);
    say(ada, client::Concede{});
    EXPECT_EQ(count<told::MatchOver>(ada), 1U);
}

TEST_F(PracticeTest, IsNotWhatAMatchOfTwoIs) {
    start_match();
    say(shooter(), client::PlaceBall{model::kEightBall, {0.2, 0.3}});
    EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::WrongGame);
    say(shooter(), client::Undo{});
    EXPECT_EQ(match_refusal(shooter()), match::RefusalCode::WrongGame);
}

TEST_F(PracticeTest, NeverTellsWhatMayBeTakenBack) {
    start_practice();
    say(ada, client::PlaceBall{model::kEightBall, {0.2, 0.3}});
    EXPECT_TRUE(last<told::MatchMoved>(ada).after.undo.empty());
}

}  // namespace
}  // namespace billiards::server
