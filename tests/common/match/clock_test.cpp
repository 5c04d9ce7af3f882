// Takes matches in every stage; gives whether their players are allowed the time they should be.
#include "common/match/clock.h"

#include "tests/common/match/match_moves.h"

#include <gtest/gtest.h>

namespace billiards::match {
namespace {

using model::Seat;

Settings clocks(double shot_s, double break_s, double extension_s = 30) {
    Settings settings;
    settings.shot_clock_s = shot_s;
    settings.break_shot_clock_s = break_s;
    settings.extension_s = extension_s;
    return settings;
}

MatchState after_break(const Settings& settings) {
    return told(started(settings), passes_to(Seat::First));
}

TEST(Clock, AllowsMoreForTheBreakThanForOtherShots) {
    EXPECT_EQ(allowance_s(started()), 60.0);
    EXPECT_EQ(allowance_s(placed(started())), 60.0);
    EXPECT_EQ(allowance_s(after_break({})), 45.0);
}

TEST(Clock, AllowsForAChoiceWhatItAllowsForAShot) {
    const MatchState match = started();
    const MatchState choosing = told(match, offers(Seat::First, {rules::Choice::Accept}));
    EXPECT_EQ(allowance_s(choosing), 45.0);
}

TEST(Clock, DoesNotRunWhereThereIsNone) {
    EXPECT_EQ(allowance_s(started(clocks(45, 0))), std::nullopt);
    EXPECT_EQ(allowance_s(after_break(clocks(45, 0))), 45.0);
    EXPECT_EQ(allowance_s(after_break(clocks(0, 60))), std::nullopt);
    EXPECT_EQ(allowance_s(applied(started(), Concede{}).next), std::nullopt);
    Settings practice;
    practice.game = rules::Game::Practice;
    EXPECT_EQ(allowance_s(started(practice)), std::nullopt);
}

TEST(Clock, AddsTheExtensionToThatTurnOnly) {
    const MatchState match = after_break({});
    const MatchState extended = applied(match, Extend{match.turn}).next;
    EXPECT_EQ(allowance_s(extended), 75.0);
    EXPECT_EQ(allowance_s(told(extended, passes_to(Seat::First))), 45.0);
    EXPECT_EQ(allowance_s(told(extended, passes_to(Seat::Second))), 45.0);
}

TEST(Clock, WarnsTenSecondsBeforeTheEnd) {
    EXPECT_EQ(warning_after_s(started()), 50.0);
    const MatchState match = after_break({});
    EXPECT_EQ(warning_after_s(match), 35.0);
    EXPECT_EQ(warning_after_s(applied(match, Extend{match.turn}).next), 65.0);
    EXPECT_EQ(warning_after_s(after_break(clocks(10, 60))), std::nullopt);
    EXPECT_EQ(warning_after_s(after_break(clocks(0, 60))), std::nullopt);
}

}  // namespace
}  // namespace billiards::match
