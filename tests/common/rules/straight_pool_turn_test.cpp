// Takes told shots after the opening break at straight pool; gives whether points, fouls, spotted
// balls and new racks are ruled as the rules say.
#include "tests/common/rules/ruling_case.h"
#include "tests/common/rules/straight_pool_state.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using model::NoCall;
using model::Safety;

using Counts = model::PerSeat<int>;

const RackState kFull = in_play();

Ruled standard_foul(std::vector<Foul> fouls, Zone in_hand = Zone::None) {
    return foul(std::move(fouls), in_hand).scoring(-1);
}

TEST(StraightPool, AnyBallMayBeHitFirstAndCalled) {
    EXPECT_EQ(straight_pool().legal_first_balls(kFull), kFull.on_table);
    for (const RackState& state : {opening(), kFull}) {
        EXPECT_TRUE(straight_pool().is_call_allowed(state, {}, call(8)));
        EXPECT_TRUE(straight_pool().is_call_allowed(state, {}, Safety{}));
        EXPECT_TRUE(straight_pool().is_call_allowed(state, {}, NoCall{}));
        EXPECT_FALSE(straight_pool().is_call_allowed(state, {}, call(8, 6)));
        EXPECT_FALSE(straight_pool().is_call_allowed(state, {}, model::PushOut{}));
    }
    EXPECT_FALSE(straight_pool().is_call_allowed(in_play(balls({1, 2})), {}, call(3)));
}

TEST(StraightPool, CalledBallScoresAPointAndOneForEachOtherBallDown) {
    expect_rulings(
        straight_pool(),
        {
            {"alone", kFull, call(3), ToldShot().hits(3).pots(3),
             continues(Reason::LegalPot).scoring(1)},
            {"off another", kFull, call(3), ToldShot().hits(8).meets(8, 3).pots(3),
             continues(Reason::LegalPot).scoring(1)},
            {"with two others", kFull, call(3), ToldShot().hits(3).pots(9, 1).pots(3).pots(5, 0),
             continues(Reason::LegalPot).scoring(3)},
        });
}

TEST(StraightPool, PotsOnAMissOrASafetyAreSpottedAndScoreNothing) {
    expect_rulings(straight_pool(),
                   {
                       {"another ball", kFull, call(3), ToldShot().hits(3).pots(4),
                        passes(Reason::NotCalled).spotting({4})},
                       {"another pocket", kFull, call(3, 1), ToldShot().hits(3).pots(3, 2),
                        passes(Reason::NotCalled).spotting({3})},
                       {"without a call", kFull, NoCall{}, ToldShot().hits(3).pots(9).pots(3),
                        passes(Reason::NotCalled).spotting({3, 9})},
                       {"on a safety", kFull, Safety{}, ToldShot().hits(3).pots(3),
                        passes(Reason::Safety).spotting({3})},
                       {"nothing", kFull, call(3), ToldShot().hits(3).cushion(3),
                        passes(Reason::NothingPotted)},
                       {"nothing on a safety", kFull, Safety{}, ToldShot().hits(3).cushion(3),
                        passes(Reason::Safety)},
                   });
}

TEST(StraightPool, StandardFoulCostsAPointAndTheCueBallStays) {
    expect_rulings(
        straight_pool(),
        {
            {"nothing hit", kFull, call(3), ToldShot().cushion(0),
             standard_foul({Foul::NoBallHit})},
            {"no cushion", kFull, call(3), ToldShot().hits(3),
             standard_foul({Foul::NoCushionAfterContact})},
            {"ball off the table", kFull, call(3), ToldShot().hits(3).leaves(3),
             standard_foul({Foul::BallOffTable}).spotting({3})},
            {"called ball and one off the table", kFull, call(3),
             ToldShot().hits(3).pots(3).leaves(2),
             standard_foul({Foul::BallOffTable}).spotting({2, 3})},
            {"two fouls cost as one", kFull, call(3), ToldShot().hits(3).leaves(3).pots(0),
             standard_foul({Foul::Scratch, Foul::BallOffTable}, Zone::BehindHeadString)
                 .spotting({3})},
        });
}

TEST(StraightPool, ScratchGivesTheCueBallInHandBehindTheHeadString) {
    const Zone behind = Zone::BehindHeadString;
    expect_rulings(straight_pool(),
                   {
                       {"alone", kFull, call(3), ToldShot().hits(3).cushion(3).pots(0),
                        standard_foul({Foul::Scratch}, behind)},
                       {"with the called ball", kFull, call(3), ToldShot().hits(3).pots(3).pots(0),
                        standard_foul({Foul::Scratch}, behind).spotting({3})},
                       {"off the table", kFull, Safety{}, ToldShot().hits(3).cushion(3).leaves(0),
                        standard_foul({Foul::Scratch}, behind)},
                   });
}

TEST(StraightPool, FromBehindTheHeadStringItMustBeCrossed) {
    RackState state = kFull;
    state.in_hand = Zone::BehindHeadString;
    state.behind_head_string = balls({3});
    expect_rulings(straight_pool(),
                   {
                       {"straight at it", state, call(3), ToldShot().hits(3).pots(3),
                        standard_foul({Foul::HeadString}).spotting({3})},
                       {"crossed", state, call(3), ToldShot().crosses_head_string().hits(3).pots(3),
                        continues(Reason::LegalPot).scoring(1)},
                   });
}

TEST(StraightPool, ScoresMayFallBelowZero) {
    const RackState zero = with_score(kFull, 0, 7);
    const Verdict verdict =
        straight_pool().judge(zero, {}, NoCall{}, ToldShot().cushion(0).facts());
    EXPECT_EQ(verdict.score_change, (Counts{{-1, 0}}));
}

TEST(StraightPool, FoulsInARowAreCountedAndResetByAShotWithoutOne) {
    const RackState state = with_fouls(kFull, 1, 2);
    const auto after = [&](const ToldShot& shot) {
        return straight_pool().judge(state, {}, call(3), shot.facts()).consecutive_fouls;
    };
    EXPECT_EQ(after(ToldShot().cushion(0)), (Counts{{2, 2}}));
    EXPECT_EQ(after(ToldShot().hits(3).pots(0)), (Counts{{2, 2}}));
    EXPECT_EQ(after(ToldShot().hits(3).cushion(3)), (Counts{{0, 2}}));
    EXPECT_EQ(after(ToldShot().hits(3).pots(3)), (Counts{{0, 2}}));
    EXPECT_EQ(straight_pool().judge_timeout(state).consecutive_fouls, (Counts{{2, 2}}));
}

TEST(StraightPool, ThirdFoulInARowCostsSixteenAndTheOffenderOpensANewRack) {
    const RackState third = with_fouls(kFull, 2, 1);
    const auto ruled = [](std::vector<Foul> fouls) {
        return Ruled{Reason::ThreeFouls, kShooter, std::move(fouls), Zone::BehindHeadString}
            .scoring(-16)
            .racking(Rerack::Fifteen);
    };
    expect_rulings(
        straight_pool(),
        {
            {"nothing hit", third, call(3), ToldShot().cushion(0), ruled({Foul::NoBallHit})},
            {"a ball fell", third, call(3), ToldShot().hits(3).pots(3).pots(0),
             ruled({Foul::Scratch})},
            {"the second", with_fouls(kFull, 1, 2), call(3), ToldShot().cushion(0),
             standard_foul({Foul::NoBallHit})},
        });
    const Verdict verdict =
        straight_pool().judge(third, {}, NoCall{}, ToldShot().cushion(0).facts());
    EXPECT_EQ(verdict.phase, Phase::Break);
    EXPECT_EQ(verdict.consecutive_fouls, (Counts{{0, 1}}));
}

TEST(StraightPool, ClockRunOutIsAStandardFoul) {
    const Ruled out{Reason::ClockRanOut, kOther, {Foul::Clock}};
    expect_ruled(straight_pool().judge_timeout(kFull), out.scoring(-1));

    RackState in_hand = kFull;
    in_hand.in_hand = Zone::BehindHeadString;
    const Ruled stays{Reason::ClockRanOut, kOther, {Foul::Clock}, Zone::BehindHeadString};
    expect_ruled(straight_pool().judge_timeout(in_hand), stays.scoring(-1));

    const Verdict third = straight_pool().judge_timeout(with_fouls(kFull, 2));
    const Ruled racked{Reason::ThreeFouls, kShooter, {Foul::Clock}, Zone::BehindHeadString};
    expect_ruled(third, racked.scoring(-16).racking(Rerack::Fifteen));
    EXPECT_EQ(third.phase, Phase::Break);
}

TEST(StraightPoolRack, FourteenAreRackedWhenOneBallIsLeft) {
    const RackState two = in_play(balls({4, 9}));
    expect_rulings(straight_pool(),
                   {
                       {"one left", two, call(4), ToldShot().hits(4).pots(4),
                        continues(Reason::LegalPot).scoring(1).racking(Rerack::Fourteen)},
                       {"two left", in_play(balls({4, 9, 11})), call(4), ToldShot().hits(4).pots(4),
                        continues(Reason::LegalPot).scoring(1)},
                       {"none fell", two, call(4), ToldShot().hits(4).cushion(4),
                        passes(Reason::NothingPotted)},
                   });
}

TEST(StraightPoolRack, FifteenAreRackedWhenTheLastFellWithTheFourteenth) {
    expect_rulings(
        straight_pool(),
        {
            {"both", in_play(balls({4, 9})), call(4), ToldShot().hits(4).pots(9, 1).pots(4),
             continues(Reason::LegalPot).scoring(2).racking(Rerack::Fifteen)},
            {"the last alone", in_play(balls({4})), call(4), ToldShot().hits(4).pots(4),
             continues(Reason::LegalPot).scoring(1).racking(Rerack::Fifteen)},
        });
}

TEST(StraightPoolRack, SpottedBallsAreLeftOnTheTable) {
    const RackState two = in_play(balls({4, 9}));
    expect_rulings(
        straight_pool(),
        {
            {"foul", two, call(4), ToldShot().hits(4).pots(4).pots(0),
             standard_foul({Foul::Scratch}, Zone::BehindHeadString).spotting({4})},
            {"foul with both down", two, call(4), ToldShot().hits(4).pots(4).pots(9).pots(0),
             standard_foul({Foul::Scratch}, Zone::BehindHeadString).spotting({4, 9})},
            {"safety", two, Safety{}, ToldShot().hits(4).pots(4),
             passes(Reason::Safety).spotting({4})},
            {"miss", two, call(4), ToldShot().hits(4).pots(9),
             passes(Reason::NotCalled).spotting({9})},
            {"miss at the only one", in_play(balls({4})), call(4), ToldShot().hits(4).cushion(4),
             passes(Reason::NothingPotted)},
            {"one spotted and one left off", two, call(4), ToldShot().hits(4).pots(4).leaves(9),
             standard_foul({Foul::BallOffTable}).spotting({4, 9})},
        });
}

TEST(StraightPool, TargetReachedWins) {
    const Options ten{.target_points = 10};
    const ToldShot pot = ToldShot().hits(3).pots(3);
    expect_rulings(
        straight_pool(),
        {
            {"exactly", with_score(kFull, 9), call(3), pot, wins(Reason::TargetReached).scoring(1)},
            {"by more", with_score(kFull, 9), call(3), ToldShot().hits(3).pots(3).pots(5),
             wins(Reason::TargetReached).scoring(2)},
            {"one short", with_score(kFull, 8), call(3), pot,
             continues(Reason::LegalPot).scoring(1)},
            {"the other's points do not count", with_score(kFull, 0, 9), call(3), pot,
             continues(Reason::LegalPot).scoring(1)},
            {"not with a foul", with_score(kFull, 9), call(3), ToldShot().hits(3).pots(3).pots(0),
             standard_foul({Foul::Scratch}, Zone::BehindHeadString).spotting({3})},
            {"not uncalled", with_score(kFull, 9), NoCall{}, pot,
             passes(Reason::NotCalled).spotting({3})},
            {"with the last but one ball nothing is racked", with_score(in_play(balls({3, 9})), 9),
             call(3), pot, wins(Reason::TargetReached).scoring(1)},
        },
        ten);
}

}  // namespace
}  // namespace billiards::rules
