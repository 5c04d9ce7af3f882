// Takes told shots at ten-ball; gives whether breaks, calls and the 10 are ruled as the rules say.
#include "common/rules/games.h"
#include "tests/common/rules/rotation_state.h"
#include "tests/common/rules/ruling_case.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using model::NoCall;
using model::Safety;

const RackState kBreak = before_break_of(kTenBalls);
const RackState kFull = with_balls(kTenBalls);
const RackState kLastTwo = with_balls(balls({9, 10}));
const RackState kLast = with_balls(balls({10}));

const Ruled kOpponentChooses = offers(Reason::UncalledPot, {Choice::Play, Choice::PassBack});

TEST(TenBallBreak, IsLegalWithAPotOrFourObjectBallsToCushionsAfterHittingTheOne) {
    expect_rulings(
        ten_ball(),
        {
            {"four to cushions", kBreak, NoCall{}, break_driving(4), passes(Reason::LegalBreak)},
            {"a pot", kBreak, NoCall{}, break_driving(0).pots(5), continues(Reason::BreakPot)},
            {"three to cushions", kBreak, NoCall{}, break_driving(3), foul({Foul::IllegalBreak})},
            {"the 2 first", kBreak, NoCall{}, ToldShot().hits(2).pots(2),
             foul({Foul::WrongBallFirst})},
            {"scratch", kBreak, NoCall{}, break_driving(4).pots(0), foul({Foul::Scratch})},
        });
}

TEST(TenBallBreak, TheTenIsSpottedAndTheBreakerContinues) {
    expect_rulings(ten_ball(),
                   {
                       {"alone", kBreak, NoCall{}, break_driving(0).pots(10),
                        continues(Reason::BreakPot).spotting({10})},
                       {"with another", kBreak, NoCall{}, break_driving(0).pots(10).pots(3),
                        continues(Reason::BreakPot).spotting({10})},
                       {"with a scratch", kBreak, NoCall{}, break_driving(0).pots(10).pots(0),
                        foul({Foul::Scratch}).spotting({10})},
                       {"off the table", kBreak, NoCall{}, break_driving(4).leaves(10),
                        foul({Foul::BallOffTable}).spotting({10})},
                   });
}

TEST(TenBallBreak, NothingIsCalled) {
    EXPECT_TRUE(ten_ball().is_call_allowed(kBreak, {}, NoCall{}));
    EXPECT_FALSE(ten_ball().is_call_allowed(kBreak, {}, Safety{}));
    EXPECT_FALSE(ten_ball().is_call_allowed(kBreak, {}, call(1)));
    expect_rulings(ten_ball(), {
                                   {"the 10 as called", kBreak, call(10), break_driving(0).pots(10),
                                    continues(Reason::BreakPot).spotting({10})},
                                   {"a safety", kBreak, Safety{}, break_driving(0).pots(3),
                                    continues(Reason::BreakPot)},
                               });
}

TEST(TenBall, AnyBallOnTheTableMayBeCalledInAnyPocket) {
    EXPECT_TRUE(ten_ball().is_call_allowed(kLastTwo, {}, call(9, 0)));
    EXPECT_TRUE(ten_ball().is_call_allowed(kLastTwo, {}, call(10, 5)));
    EXPECT_TRUE(ten_ball().is_call_allowed(kLastTwo, {}, Safety{}));
    EXPECT_TRUE(ten_ball().is_call_allowed(kLastTwo, {}, NoCall{}));
    EXPECT_FALSE(ten_ball().is_call_allowed(kLastTwo, {}, call(1)));
    EXPECT_FALSE(ten_ball().is_call_allowed(kLastTwo, {}, call(10, 6)));
    EXPECT_FALSE(ten_ball().is_call_allowed(kLastTwo, {}, model::PushOut{}));
}

TEST(TenBall, LowestBallMustBeHitFirstWhateverIsCalled) {
    EXPECT_EQ(ten_ball().legal_first_balls(kLastTwo), balls({9}));
    expect_rulings(ten_ball(),
                   {
                       {"combination", kFull, call(6), ToldShot().hits(1).meets(1, 6).pots(6),
                        continues(Reason::LegalPot)},
                       {"called ball first", kFull, call(6), ToldShot().hits(6).pots(6),
                        foul({Foul::WrongBallFirst})},
                   });
}

TEST(TenBall, CalledBallMadeContinuesAndExtrasStayDownButForTheTen) {
    expect_rulings(
        ten_ball(),
        {
            {"alone", kFull, call(1), ToldShot().hits(1).pots(1), continues(Reason::LegalPot)},
            {"with another", kFull, call(1), ToldShot().hits(1).pots(1).pots(4),
             continues(Reason::LegalPot)},
            {"with the 10", kFull, call(1), ToldShot().hits(1).pots(10).pots(1),
             continues(Reason::LegalPot).spotting({10})},
        });
}

TEST(TenBall, BallDownWithoutTheCalledOneLetsTheOpponentChoose) {
    expect_rulings(
        ten_ball(),
        {
            {"another ball", kFull, call(1), ToldShot().hits(1).pots(4), kOpponentChooses},
            {"another pocket", kFull, call(1, 3), ToldShot().hits(1).pots(1, 2), kOpponentChooses},
            {"without a call", kFull, NoCall{}, ToldShot().hits(1).pots(1), kOpponentChooses},
            {"on a safety", kFull, Safety{}, ToldShot().hits(1).pots(1), kOpponentChooses},
            {"the 10", kFull, call(1), ToldShot().hits(1).pots(10),
             kOpponentChooses.spotting({10})},
            {"with a foul", kFull, call(1), ToldShot().hits(1).pots(4).pots(0),
             foul({Foul::Scratch})},
        });
}

TEST(TenBall, CallThatMayNotBeSaidIsJudgedAsIfUnsaid) {
    expect_rulings(ten_ball(), {
                                   {"a ball that is not there", kLastTwo, call(3),
                                    ToldShot().hits(9).pots(9), kOpponentChooses},
                                   {"a push-out", kFull, model::PushOut{},
                                    ToldShot().hits(1).pots(1), kOpponentChooses},
                               });
}

TEST(TenBall, OpponentPlaysOnOrPassesBack) {
    const Verdict verdict =
        ten_ball().judge(kFull, {}, call(1), ToldShot().hits(1).pots(4).facts());
    const Resolution plays{false, kOther, Zone::None, {}};
    const Resolution passes_back{false, kShooter, Zone::None, {}};
    EXPECT_EQ(ten_ball().resolve(kFull, verdict, Choice::Play), plays);
    EXPECT_EQ(ten_ball().resolve(kFull, verdict, Choice::PassBack), passes_back);
}

TEST(TenBall, NothingDownPassesTheTurn) {
    const ToldShot miss = ToldShot().hits(1).cushion(1);
    expect_rulings(ten_ball(),
                   {
                       {"after a call", kFull, call(1), miss, passes(Reason::NothingPotted)},
                       {"without one", kFull, NoCall{}, miss, passes(Reason::NothingPotted)},
                       {"on a safety", kFull, Safety{}, miss, passes(Reason::Safety)},
                   });
}

TEST(TenBall, TheTenWinsOnlyWhenCalledAsTheLastBall) {
    const Ruled early = continues(Reason::TenEarly).spotting({10});
    expect_rulings(
        ten_ball(),
        {
            {"last", kLast, call(10), ToldShot().hits(10).pots(10), wins(Reason::TenWon)},
            {"early by a combination", kFull, call(10), ToldShot().hits(1).meets(1, 10).pots(10),
             early},
            {"one too early", kLastTwo, call(10), ToldShot().hits(9).meets(9, 10).pots(10), early},
            {"after the other in one shot", kLastTwo, call(10), ToldShot().hits(9).pots(9).pots(10),
             early},
            {"in another pocket", kLast, call(10, 1), ToldShot().hits(10).pots(10, 2),
             kOpponentChooses.spotting({10})},
            {"uncalled", kLast, NoCall{}, ToldShot().hits(10).pots(10),
             kOpponentChooses.spotting({10})},
            {"with a scratch", kLast, call(10), ToldShot().hits(10).pots(10).pots(0),
             foul({Foul::Scratch}).spotting({10})},
        });
}

TEST(TenBall, TheCalledTenWinsAnyTimeWhereTheOptionSaysSo) {
    const ToldShot combination = ToldShot().hits(1).meets(1, 10).pots(10);
    expect_rulings(ten_ball(),
                   {
                       {"called", kFull, call(10), combination, wins(Reason::TenWon)},
                       {"uncalled", kFull, call(1), combination, kOpponentChooses.spotting({10})},
                       {"on the break", kBreak, NoCall{}, break_driving(0).pots(10),
                        continues(Reason::BreakPot).spotting({10})},
                       {"with a foul", kFull, call(10), ToldShot().hits(10).pots(10),
                        foul({Foul::WrongBallFirst}).spotting({10})},
                   },
                   {.ten_wins_any_time = true});
}

TEST(TenBall, OnlyTheTenIsEverSpotted) {
    expect_rulings(ten_ball(), {
                                   {"pot on a foul", kFull, call(1),
                                    ToldShot().hits(1).pots(1).pots(0), foul({Foul::Scratch})},
                                   {"off the table", kFull, call(1), ToldShot().hits(1).leaves(1),
                                    foul({Foul::BallOffTable})},
                                   {"the 10 off the table", kFull, call(1),
                                    ToldShot().hits(1).pots(1).leaves(10),
                                    foul({Foul::BallOffTable}).spotting({10})},
                               });
}

TEST(TenBall, ClockRunOutIsAFoulWithBallInHandAnywhere) {
    expect_ruled(ten_ball().judge_timeout(kFull),
                 {Reason::ClockRanOut, kOther, {Foul::Clock}, Zone::Anywhere});
    expect_ruled(ten_ball().judge_timeout(kBreak),
                 {Reason::ClockRanOut, kOther, {Foul::Clock}, Zone::BehindHeadString});
}

}  // namespace
}  // namespace billiards::rules
