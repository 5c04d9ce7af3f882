// Takes told shots at practice; gives whether nobody is judged.
#include "common/rules/games.h"
#include "tests/common/rules/eight_ball_state.h"
#include "tests/common/rules/ruling_case.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using model::NoCall;

Ruled plays_on(Zone in_hand = Zone::None) {
    return {Reason::Practice, kShooter, {}, in_hand};
}

TEST(Practice, KnowsNoFoulsAndAlwaysTheSameShooter) {
    const RackState full = open_without({});
    const RackState eight = open_without(open_without({}).on_table - balls({8}));
    expect_rulings(
        practice(),
        {
            {"a pot", full, NoCall{}, ToldShot().hits(3).pots(3), plays_on()},
            {"a miss", full, NoCall{}, ToldShot().hits(3).cushion(3), plays_on()},
            {"nothing hit", full, NoCall{}, ToldShot().cushion(0), plays_on()},
            {"no cushion", full, NoCall{}, ToldShot().hits(3), plays_on()},
            {"ball off the table", full, NoCall{}, ToldShot().hits(3).leaves(3), plays_on()},
            {"the 8 first", full, NoCall{}, ToldShot().hits(8).pots(8), plays_on()},
            {"the last ball", eight, NoCall{}, ToldShot().hits(8).pots(8), plays_on()},
            {"a cleared table", open_without(full.on_table), NoCall{}, ToldShot().cushion(0),
             plays_on()},
        });
}

TEST(Practice, ScratchGivesTheCueBallInHandAnywhere) {
    const RackState full = open_without({});
    expect_rulings(practice(),
                   {
                       {"pocketed", full, NoCall{}, ToldShot().pots(0), plays_on(Zone::Anywhere)},
                       {"off the table", full, NoCall{}, ToldShot().hits(3).leaves(0),
                        plays_on(Zone::Anywhere)},
                   });
}

TEST(Practice, BreakIsAShotLikeAnyOther) {
    const Verdict verdict =
        practice().judge(at_break(), {}, NoCall{}, ToldShot().hits(1).cushion(1).facts());
    expect_ruled(verdict, plays_on());
    EXPECT_EQ(verdict.phase, Phase::Groups);
}

TEST(Practice, EveryBallOnTheTableMayBeHitAndNothingIsCalled) {
    const RackState state = open_without(balls({1, 2}));
    EXPECT_EQ(practice().legal_first_balls(state), state.on_table);
    EXPECT_TRUE(practice().is_call_allowed(state, {}, NoCall{}));
    EXPECT_FALSE(practice().is_call_allowed(state, {}, call(3)));
}

TEST(Practice, ClockChangesNothing) {
    const Verdict verdict = practice().judge_timeout(at_break());
    expect_ruled(verdict, plays_on(Zone::BehindHeadString));
    EXPECT_EQ(verdict.phase, Phase::Break);
}

}  // namespace
}  // namespace billiards::rules
