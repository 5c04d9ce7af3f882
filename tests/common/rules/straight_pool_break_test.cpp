// Takes told opening breaks at straight pool; gives whether they are ruled as the rules say.
#include "tests/common/rules/ruling_case.h"
#include "tests/common/rules/straight_pool_state.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using model::NoCall;
using model::Safety;

const RackState kOpening = opening();

/// Hits the 1; the cue ball and that many object balls go to cushions after it.
ToldShot opening_driving(int object_balls) {
    ToldShot shot;
    shot.hits(1).cushion(0);
    for (int ball = 1; ball <= object_balls; ++ball) shot.cushion(ball);
    return shot;
}

Ruled breaking_foul(std::vector<Foul> fouls = {Foul::BreakingFoul}, Zone in_hand = Zone::None) {
    return {Reason::BreakingFoul,
            kOther,
            std::move(fouls),
            in_hand,
            {Choice::Accept, Choice::RebreakOpponent},
            {},
            {},
            -2};
}

TEST(StraightPoolBreak, IsGoodWithTheCueBallAndTwoObjectBallsToCushions) {
    expect_rulings(
        straight_pool(),
        {
            {"two", kOpening, NoCall{}, opening_driving(2), passes(Reason::LegalBreak)},
            {"three", kOpening, NoCall{}, opening_driving(3), passes(Reason::LegalBreak)},
            {"a safety", kOpening, Safety{}, opening_driving(2), passes(Reason::Safety)},
            {"a called ball missed", kOpening, call(4), opening_driving(2),
             passes(Reason::LegalBreak)},
            {"a fallen ball is driven", kOpening, NoCall{}, opening_driving(1).pots(4),
             passes(Reason::NotCalled).spotting({4})},
        });
}

TEST(StraightPoolBreak, IsGoodWithTheCalledBallWhateverElseIsDriven) {
    expect_rulings(straight_pool(),
                   {
                       {"as called", kOpening, call(4), ToldShot().hits(1).pots(4),
                        continues(Reason::LegalPot).scoring(1)},
                       {"in another pocket", kOpening, call(4, 1), ToldShot().hits(1).pots(4, 2),
                        breaking_foul().spotting({4})},
                       {"uncalled", kOpening, NoCall{}, ToldShot().hits(1).pots(4),
                        breaking_foul().spotting({4})},
                   });
}

TEST(StraightPoolBreak, IsABreakingFoulWhereLessIsDriven) {
    expect_rulings(
        straight_pool(),
        {
            {"one object ball", kOpening, NoCall{}, opening_driving(1), breaking_foul()},
            {"one object ball twice", kOpening, NoCall{}, opening_driving(1).cushion(1),
             breaking_foul()},
            {"two without the cue ball", kOpening, NoCall{},
             ToldShot().hits(1).cushion(1).cushion(2), breaking_foul()},
            {"the cue ball only before the contact", kOpening, NoCall{},
             ToldShot().cushion(0).hits(1).cushion(1).cushion(2), breaking_foul()},
            {"a held cushion", kOpening, NoCall{}, opening_driving(1).cushion(2, true),
             breaking_foul()},
            {"a safety does not help", kOpening, Safety{}, opening_driving(1), breaking_foul()},
        });
}

TEST(StraightPoolBreak, BreakingFoulReplacesStandardFoulsAndLeavesTheirCount) {
    const RackState twice = with_fouls(kOpening, 2, 1);
    expect_rulings(straight_pool(),
                   {
                       {"nothing hit", twice, NoCall{}, ToldShot().cushion(0),
                        breaking_foul({Foul::NoBallHit, Foul::BreakingFoul})},
                       {"a ball off the table", twice, NoCall{}, ToldShot().hits(1).leaves(1),
                        breaking_foul({Foul::BallOffTable, Foul::BreakingFoul}).spotting({1})},
                   });
    const Verdict verdict =
        straight_pool().judge(twice, {}, NoCall{}, ToldShot().cushion(0).facts());
    EXPECT_EQ(verdict.consecutive_fouls, twice.consecutive_fouls);
}

TEST(StraightPoolBreak, OpponentAcceptsOrOrdersAnotherBreak) {
    const Verdict verdict =
        straight_pool().judge(kOpening, {}, NoCall{}, opening_driving(1).facts());
    const Resolution accepts{false, kOther, Zone::None, {}};
    const Resolution again{true, kShooter, Zone::BehindHeadString, {}};
    EXPECT_EQ(straight_pool().resolve(kOpening, verdict, Choice::Accept), accepts);
    EXPECT_EQ(straight_pool().resolve(kOpening, verdict, Choice::RebreakOpponent), again);
}

TEST(StraightPoolBreak, CueBallThatWentDownIsAcceptedBehindTheHeadString) {
    const ToldShot shot = ToldShot().hits(1).pots(0);
    const Zone behind = Zone::BehindHeadString;
    expect_rulings(straight_pool(), {{"scratch", kOpening, NoCall{}, shot,
                                      breaking_foul({Foul::Scratch, Foul::BreakingFoul}, behind)}});
    const Verdict verdict = straight_pool().judge(kOpening, {}, NoCall{}, shot.facts());
    const Resolution accepts{false, kOther, behind, {}};
    EXPECT_EQ(straight_pool().resolve(kOpening, verdict, Choice::Accept), accepts);
}

TEST(StraightPoolBreak, StandardFoulsOnAGoodOneCostWhatTheyAlwaysCost) {
    const Zone behind = Zone::BehindHeadString;
    expect_rulings(
        straight_pool(),
        {
            {"scratch", kOpening, NoCall{}, opening_driving(2).pots(0),
             foul({Foul::Scratch}, behind).scoring(-1)},
            {"scratch after the called ball", kOpening, call(4), ToldShot().hits(1).pots(4).pots(0),
             foul({Foul::Scratch}, behind).spotting({4}).scoring(-1)},
            {"a ball off the table", kOpening, NoCall{}, opening_driving(2).leaves(9),
             foul({Foul::BallOffTable}, Zone::None).spotting({9}).scoring(-1)},
        });
}

TEST(StraightPoolBreak, IsOverAfterOneShot) {
    for (const ToldShot& shot : {opening_driving(2), opening_driving(1), ToldShot().pots(0)}) {
        const Verdict verdict = straight_pool().judge(kOpening, {}, NoCall{}, shot.facts());
        EXPECT_EQ(verdict.phase, Phase::Groups);
    }
}

TEST(StraightPoolBreak, ClockThatRunsOutBeforeItLetsTheOtherPlayerBreak) {
    const Verdict verdict = straight_pool().judge_timeout(kOpening);
    expect_ruled(
        verdict,
        Ruled{Reason::ClockRanOut, kOther, {Foul::Clock}, Zone::BehindHeadString}.scoring(-1));
    EXPECT_EQ(verdict.phase, Phase::Break);
}

}  // namespace
}  // namespace billiards::rules
