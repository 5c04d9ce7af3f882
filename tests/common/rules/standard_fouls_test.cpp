// Takes told shots; gives whether exactly the right fouls are named.
#include "common/rules/standard_fouls.h"

#include "tests/common/rules/told_shot.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using enum Foul;

struct FoulCase {
    const char* what;
    ToldShot shot;
    std::vector<Foul> fouls;
};

void expect_fouls(const RackState& state, std::initializer_list<FoulCase> cases) {
    for (const FoulCase& each : cases) {
        EXPECT_EQ(standard_fouls(state, balls({1, 2}), each.shot.facts()), each.fouls) << each.what;
    }
}

TEST(StandardFouls, EachIsNamedWhereItHappensAndNowhereElse) {
    expect_fouls(RackState{},
                 {
                     {"legal hit and cushion", ToldShot().hits(1).cushion(1), {}},
                     {"legal pot", ToldShot().hits(1).pots(1), {}},
                     {"cue ball pocketed", ToldShot().hits(1).cushion(1).pots(0), {Scratch}},
                     {"cue ball off the table", ToldShot().hits(1).cushion(1).leaves(0), {Scratch}},
                     {"nothing hit", ToldShot().cushion(0), {NoBallHit}},
                     {"wrong ball first", ToldShot().hits(9).hits(1).cushion(1), {WrongBallFirst}},
                     {"no cushion", ToldShot().hits(1).moves(1), {NoCushionAfterContact}},
                     {"ball off the table", ToldShot().hits(1).leaves(1), {BallOffTable}},
                 });
}

TEST(StandardFouls, OfContactsAtTheSameInstantTheLegalOneCounts) {
    expect_fouls(
        RackState{},
        {
            {"told first", ToldShot().hits(1).at_once().hits(9).cushion(1), {}},
            {"told last", ToldShot().hits(9).at_once().hits(1).cushion(1), {}},
            {"neither", ToldShot().hits(9).at_once().hits(10).cushion(9), {WrongBallFirst}},
        });
}

TEST(StandardFouls, FrozenBallIsHitWhenShotIntoAndNotWhenShotAwayFrom) {
    expect_fouls(RackState{},
                 {
                     {"into it, at the strike", ToldShot().at_once().hits(1).cushion(0), {}},
                     {"away from it", ToldShot().cushion(0), {NoBallHit}},
                 });
}

TEST(StandardFouls, SeveralAreListedInTheOrderOfTheEnum) {
    expect_fouls(RackState{},
                 {
                     {"scratch without a hit", ToldShot().pots(0), {Scratch, NoBallHit}},
                     {"everything at once",
                      ToldShot().hits(9).leaves(9).pots(0),
                      {Scratch, WrongBallFirst, BallOffTable}},
                     {"wrong ball and no cushion",
                      ToldShot().hits(9),
                      {WrongBallFirst, NoCushionAfterContact}},
                 });
}

TEST(StandardFouls, FromBehindTheHeadStringItMustBeCrossedBeforeABallBehindItIsTouched) {
    RackState state;
    state.in_hand = Zone::BehindHeadString;
    state.behind_head_string = balls({1, 9});
    expect_fouls(
        state,
        {
            {"straight at it", ToldShot().hits(1).cushion(1), {HeadString}},
            {"crossed and came back", ToldShot().crosses_head_string().hits(1).cushion(1), {}},
            {"crossed only after it",
             ToldShot().hits(1).crosses_head_string().cushion(1),
             {HeadString}},
            {"a ball over the line first", ToldShot().hits(2).hits(1).cushion(1), {}},
            {"both at once", ToldShot().hits(1).at_once().hits(2).cushion(1), {}},
            {"nothing hit", ToldShot().cushion(0), {NoBallHit}},
            {"wrong ball behind it", ToldShot().hits(9).cushion(9), {WrongBallFirst, HeadString}},
        });
}

TEST(StandardFouls, HeadStringMeansNothingWhenTheCueBallWasNotInHandBehindIt) {
    RackState state;
    state.behind_head_string = balls({1});
    for (const Zone zone : {Zone::None, Zone::Anywhere}) {
        state.in_hand = zone;
        expect_fouls(state, {{"straight at it", ToldShot().hits(1).cushion(1), {}}});
    }
}

}  // namespace
}  // namespace billiards::rules
