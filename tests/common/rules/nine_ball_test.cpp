// Takes told shots at nine-ball; gives whether breaks, turns and the 9 are ruled as the rules say.
#include "common/rules/games.h"
#include "tests/common/rules/rotation_state.h"
#include "tests/common/rules/ruling_case.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using model::NoCall;

const RackState kBreak = before_break_of(kNineBalls);
const RackState kFull = with_balls(kNineBalls);

TEST(NineBallBreak, IsLegalWithAPotOrFourObjectBallsToCushionsAfterHittingTheOne) {
    expect_rulings(nine_ball(), {
                                    {"four to cushions", kBreak, NoCall{}, break_driving(4),
                                     passes(Reason::LegalBreak)},
                                    {"one pocketed", kBreak, NoCall{}, break_driving(0).pots(5),
                                     continues(Reason::BreakPot)},
                                    {"two pocketed", kBreak, NoCall{},
                                     break_driving(0).pots(5).pots(1), continues(Reason::BreakPot)},
                                });
}

TEST(NineBallBreak, IsAFoulWithThreeObjectBallsToCushionsAndNoPot) {
    const Ruled illegal = foul({Foul::IllegalBreak});
    expect_rulings(
        nine_ball(),
        {
            {"three", kBreak, NoCall{}, break_driving(3), illegal},
            {"three and the cue ball", kBreak, NoCall{}, break_driving(3).cushion(0), illegal},
            {"one of them twice", kBreak, NoCall{}, break_driving(3).cushion(1), illegal},
            {"none", kBreak, NoCall{}, break_driving(0),
             foul({Foul::NoCushionAfterContact, Foul::IllegalBreak})},
            {"nothing hit", kBreak, NoCall{}, ToldShot().cushion(0),
             foul({Foul::NoBallHit, Foul::IllegalBreak})},
        });
}

TEST(NineBallBreak, MustHitTheOneFirst) {
    expect_rulings(
        nine_ball(),
        {
            {"the 2 first", kBreak, NoCall{}, ToldShot().hits(2).hits(1).pots(5),
             foul({Foul::WrongBallFirst})},
            {"both at once", kBreak, NoCall{}, ToldShot().hits(2).at_once().hits(1).pots(5),
             continues(Reason::BreakPot)},
            {"the 2 first and too little driven", kBreak, NoCall{}, ToldShot().hits(2).cushion(2),
             foul({Foul::WrongBallFirst, Foul::IllegalBreak})},
        });
}

TEST(NineBallBreak, EveryFoulGivesBallInHandAnywhereAndNoChoice) {
    expect_rulings(nine_ball(), {
                                    {"scratch", kBreak, NoCall{}, break_driving(4).pots(0),
                                     foul({Foul::Scratch})},
                                    {"scratch after a pot", kBreak, NoCall{},
                                     break_driving(0).pots(5).pots(0), foul({Foul::Scratch})},
                                    {"ball off the table", kBreak, NoCall{},
                                     break_driving(4).leaves(5), foul({Foul::BallOffTable})},
                                });
}

TEST(NineBallBreak, TheNineWinsOnALegalOneAndIsSpottedOnAFoul) {
    expect_rulings(nine_ball(),
                   {
                       {"legal", kBreak, NoCall{}, break_driving(0).pots(9), wins(Reason::NineWon)},
                       {"scratch", kBreak, NoCall{}, break_driving(0).pots(9).pots(0),
                        foul({Foul::Scratch}).spotting({9})},
                       {"the 2 first", kBreak, NoCall{}, ToldShot().hits(2).pots(9),
                        foul({Foul::WrongBallFirst}).spotting({9})},
                       {"off the table", kBreak, NoCall{}, break_driving(4).leaves(9),
                        foul({Foul::BallOffTable}).spotting({9})},
                   });
}

TEST(NineBallBreak, ClockThatRunsOutBeforeItLetsTheOtherPlayerBreak) {
    const Verdict verdict = nine_ball().judge_timeout(kBreak);
    expect_ruled(verdict, {Reason::ClockRanOut, kOther, {Foul::Clock}, Zone::BehindHeadString});
    EXPECT_EQ(verdict.phase, Phase::Break);
    EXPECT_EQ(verdict.consecutive_fouls, (model::PerSeat<int>{{1, 0}}));
}

TEST(NineBall, LowestBallOnTheTableMustBeHitFirst) {
    const RackState three_up = with_balls(balls({3, 7, 9}));
    EXPECT_EQ(nine_ball().legal_first_balls(kFull), balls({1}));
    EXPECT_EQ(nine_ball().legal_first_balls(three_up), balls({3}));
    EXPECT_EQ(nine_ball().legal_first_balls(with_balls(balls({9}))), balls({9}));
    expect_rulings(nine_ball(), {
                                    {"the lowest", three_up, NoCall{}, ToldShot().hits(3).pots(3),
                                     continues(Reason::LegalPot)},
                                    {"another", three_up, NoCall{}, ToldShot().hits(7).pots(7),
                                     foul({Foul::WrongBallFirst})},
                                    {"the 9", three_up, NoCall{}, ToldShot().hits(9).cushion(9),
                                     foul({Foul::WrongBallFirst})},
                                });
}

TEST(NineBall, AnyLegalPotContinuesAndAMissPassesTheTurn) {
    expect_rulings(nine_ball(),
                   {
                       {"the lowest", kFull, NoCall{}, ToldShot().hits(1).pots(1),
                        continues(Reason::LegalPot)},
                       {"another by a combination", kFull, NoCall{},
                        ToldShot().hits(1).meets(1, 6).pots(6), continues(Reason::LegalPot)},
                       {"nothing", kFull, NoCall{}, ToldShot().hits(1).cushion(1),
                        passes(Reason::NothingPotted)},
                   });
}

TEST(NineBall, EveryFoulGivesBallInHandAnywhereAndTheBallsStayDown) {
    expect_rulings(
        nine_ball(),
        {
            {"scratch", kFull, NoCall{}, ToldShot().hits(1).pots(1).pots(0), foul({Foul::Scratch})},
            {"nothing hit", kFull, NoCall{}, ToldShot().cushion(0), foul({Foul::NoBallHit})},
            {"no cushion", kFull, NoCall{}, ToldShot().hits(1),
             foul({Foul::NoCushionAfterContact})},
            {"ball off the table", kFull, NoCall{}, ToldShot().hits(1).pots(1).leaves(4),
             foul({Foul::BallOffTable})},
            {"three to cushions are too few on the break only", kFull, NoCall{}, break_driving(3),
             passes(Reason::NothingPotted)},
        });
}

TEST(NineBall, TheNineWinsOnAnyLegalShotAndIsSpottedOnAFoul) {
    const RackState last = with_balls(balls({9}));
    expect_rulings(
        nine_ball(),
        {
            {"last of all", last, NoCall{}, ToldShot().hits(9).pots(9), wins(Reason::NineWon)},
            {"by a combination", kFull, NoCall{}, ToldShot().hits(1).meets(1, 9).pots(9),
             wins(Reason::NineWon)},
            {"with the lowest ball", kFull, NoCall{}, ToldShot().hits(1).pots(1).pots(9),
             wins(Reason::NineWon)},
            {"with a scratch", last, NoCall{}, ToldShot().hits(9).pots(9).pots(0),
             foul({Foul::Scratch}).spotting({9})},
            {"hit first too early", kFull, NoCall{}, ToldShot().hits(9).pots(9),
             foul({Foul::WrongBallFirst}).spotting({9})},
            {"with another ball off the table", kFull, NoCall{},
             ToldShot().hits(1).pots(9).leaves(1), foul({Foul::BallOffTable}).spotting({9})},
            {"off the table", kFull, NoCall{}, ToldShot().hits(1).meets(1, 9).leaves(9),
             foul({Foul::BallOffTable}).spotting({9})},
        });
}

TEST(NineBall, NothingIsCalledAndACallIsJudgedAsIfUnsaid) {
    EXPECT_TRUE(nine_ball().is_call_allowed(kFull, {}, NoCall{}));
    for (const RackState& state : {kBreak, kFull, after_break_of(kNineBalls)}) {
        EXPECT_FALSE(nine_ball().is_call_allowed(state, {}, call(1)));
        EXPECT_FALSE(nine_ball().is_call_allowed(state, {}, model::Safety{}));
    }
    const ToldShot shot = ToldShot().hits(1).pots(3);
    expect_rulings(nine_ball(),
                   {
                       {"another ball", kFull, call(1), shot, continues(Reason::LegalPot)},
                       {"a safety", kFull, model::Safety{}, shot, continues(Reason::LegalPot)},
                   });
}

TEST(NineBall, ClockRunOutIsAFoulWithBallInHandAnywhere) {
    const Verdict verdict = nine_ball().judge_timeout(kFull);
    expect_ruled(verdict, {Reason::ClockRanOut, kOther, {Foul::Clock}, Zone::Anywhere});
    EXPECT_EQ(verdict.phase, Phase::Groups);
    EXPECT_EQ(verdict.consecutive_fouls, (model::PerSeat<int>{{1, 0}}));
}

TEST(NineBall, TimeOutAfterTheBreakUsesUpThePushOut) {
    EXPECT_EQ(nine_ball().judge_timeout(after_break_of(kNineBalls)).phase, Phase::Groups);
}

}  // namespace
}  // namespace billiards::rules
