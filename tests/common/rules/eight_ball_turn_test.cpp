// Takes told shots after the break at eight-ball; gives whether turn, fouls, groups and calls are
// ruled as the rules say.
#include "tests/common/rules/eight_ball_state.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using model::NoCall;
using model::Safety;

const Options kNoCalls{.call = false};

void expect_passes(const Verdict& verdict, Reason reason) {
    EXPECT_EQ(verdict.reason, reason);
    EXPECT_EQ(verdict.next_player, kOther);
    EXPECT_FALSE(verdict.turn_continues);
    EXPECT_EQ(verdict.in_hand, Zone::None);
    EXPECT_TRUE(verdict.fouls.empty());
    EXPECT_EQ(verdict.winner, std::nullopt);
}

void expect_continues(const Verdict& verdict) {
    EXPECT_EQ(verdict.reason, Reason::LegalPot);
    EXPECT_EQ(verdict.next_player, kShooter);
    EXPECT_TRUE(verdict.turn_continues);
    EXPECT_EQ(verdict.in_hand, Zone::None);
    EXPECT_TRUE(verdict.fouls.empty());
}

void expect_foul(const Verdict& verdict, std::vector<Foul> fouls) {
    EXPECT_EQ(verdict.reason, Reason::Foul);
    EXPECT_EQ(verdict.fouls, fouls);
    EXPECT_EQ(verdict.next_player, kOther);
    EXPECT_FALSE(verdict.turn_continues);
    EXPECT_EQ(verdict.in_hand, Zone::Anywhere);
    EXPECT_EQ(verdict.winner, std::nullopt);
    EXPECT_TRUE(verdict.choices.empty());
}

TEST(EightBallOpenTable, AnyBallButTheEightMayBeHitFirst) {
    const RackState open = open_without({});
    EXPECT_EQ(eight_ball().legal_first_balls(open), open.on_table - balls({8}));
    expect_continues(judged(open, call(3), ToldShot().hits(12).meets(12, 3).pots(3)));
    expect_foul(judged(open, call(3), ToldShot().hits(8).meets(8, 3).pots(3)),
                {Foul::WrongBallFirst});
}

TEST(EightBallOpenTable, CalledBallDownSetsTheGroups) {
    const RackState open = open_without({});
    EXPECT_EQ(judged(open, call(3), ToldShot().hits(3).pots(3)).groups, shooter_has(Group::Solids));
    EXPECT_EQ(judged(open, call(12), ToldShot().hits(12).pots(12)).groups,
              shooter_has(Group::Stripes));
}

TEST(EightBallOpenTable, GroupsFollowTheCalledBallEvenWhenAnotherFellFirst) {
    const Verdict verdict = judged(open_without({}), call(3), ToldShot().hits(3).pots(12).pots(3));
    EXPECT_EQ(verdict.groups, shooter_has(Group::Solids));
}

TEST(EightBallOpenTable, GroupsOfTheSecondSeatAreSetLikewise) {
    RackState open = open_without({});
    open.shooter = kOther;
    const Verdict verdict = judged(open, call(3), ToldShot().hits(3).pots(3));
    ASSERT_TRUE(verdict.groups.has_value());
    EXPECT_EQ((*verdict.groups)[kOther], Group::Solids);
    EXPECT_EQ((*verdict.groups)[kShooter], Group::Stripes);
}

TEST(EightBallOpenTable, StaysOpenWithoutALegalCalledPot) {
    const RackState open = open_without({});
    struct {
        const char* what;
        model::Call said;
        ToldShot shot;
    } const cases[] = {
        {"uncalled", NoCall{}, ToldShot().hits(3).pots(3)},
        {"another ball", call(3), ToldShot().hits(3).pots(4)},
        {"another pocket", call(3, 1), ToldShot().hits(3).pots(3, 2)},
        {"with a foul", call(3), ToldShot().hits(3).pots(3).pots(0)},
        {"on a safety", Safety{}, ToldShot().hits(3).pots(3)},
        {"nothing down", call(3), ToldShot().hits(3).cushion(3)},
    };
    for (const auto& each : cases) {
        EXPECT_EQ(judged(open, each.said, each.shot).groups, std::nullopt) << each.what;
    }
}

TEST(EightBallOpenTable, WhereOneGroupIsGoneTheEightMayBeHitFirstAndCalled) {
    const RackState open = open_without(kAllSolids);
    EXPECT_EQ(eight_ball().legal_first_balls(open), kAllStripes | balls({8}));
    EXPECT_TRUE(eight_ball().is_call_allowed(open, {}, call(8)));
    EXPECT_TRUE(eight_ball().is_call_allowed(open, {}, call(12)));
    const Verdict won = judged(open, call(8), ToldShot().hits(8).pots(8));
    EXPECT_EQ(won.winner, kShooter);
    EXPECT_EQ(won.reason, Reason::EightWon);
    EXPECT_EQ(judged(open, call(12), ToldShot().hits(8).meets(8, 12).pots(12)).groups,
              shooter_has(Group::Stripes));
}

TEST(EightBallOpenTable, WhereBothGroupsAreGoneTheShooterIsOnTheEight) {
    const RackState open = open_without(kAllSolids | kAllStripes);
    EXPECT_EQ(eight_ball().legal_first_balls(open), balls({8}));
    EXPECT_EQ(judged(open, call(8), ToldShot().hits(8).pots(8)).winner, kShooter);
}

TEST(EightBallGroups, OwnGroupMustBeHitFirst) {
    const RackState state = solids_without({});
    EXPECT_EQ(eight_ball().legal_first_balls(state), kAllSolids);
    expect_passes(judged(state, NoCall{}, ToldShot().hits(3).cushion(3)), Reason::NothingPotted);
    expect_foul(judged(state, NoCall{}, ToldShot().hits(12).cushion(12)), {Foul::WrongBallFirst});
    expect_foul(judged(state, NoCall{}, ToldShot().hits(8).cushion(8)), {Foul::WrongBallFirst});
}

TEST(EightBallGroups, TheEightMustBeHitFirstOnceTheGroupIsDown) {
    const RackState state = solids_without(kAllSolids);
    EXPECT_EQ(eight_ball().legal_first_balls(state), balls({8}));
    expect_passes(judged(state, NoCall{}, ToldShot().hits(8).cushion(8)), Reason::NothingPotted);
    expect_foul(judged(state, NoCall{}, ToldShot().hits(12).cushion(12)), {Foul::WrongBallFirst});
}

TEST(EightBallGroups, CalledBallInItsPocketKeepsTheTurn) {
    const RackState state = solids_without({});
    expect_continues(judged(state, call(3), ToldShot().hits(3).pots(3)));
    expect_continues(judged(state, call(3), ToldShot().hits(4).meets(4, 3).pots(12).pots(3)));
}

TEST(EightBallGroups, MissedCallPassesTheTurnAndBallsThatFellStayDown) {
    const RackState state = solids_without({});
    const Verdict other_ball = judged(state, call(3), ToldShot().hits(3).pots(4));
    expect_passes(other_ball, Reason::NotCalled);
    EXPECT_TRUE(other_ball.spotted.empty());
    expect_passes(judged(state, call(3, 1), ToldShot().hits(3).pots(3, 2)), Reason::NotCalled);
    expect_passes(judged(state, call(3), ToldShot().hits(3).cushion(3)), Reason::NothingPotted);
}

TEST(EightBallGroups, PotWithoutACallPassesTheTurn) {
    expect_passes(judged(solids_without({}), NoCall{}, ToldShot().hits(3).pots(3)),
                  Reason::NotCalled);
}

TEST(EightBallGroups, SafetyPassesTheTurnEvenAfterAPot) {
    const RackState state = solids_without({});
    expect_passes(judged(state, Safety{}, ToldShot().hits(3).pots(3)), Reason::Safety);
    expect_passes(judged(state, Safety{}, ToldShot().hits(3).cushion(3)), Reason::Safety);
    expect_foul(judged(state, Safety{}, ToldShot().hits(3)), {Foul::NoCushionAfterContact});
}

TEST(EightBallGroups, GroupsStayAsTheyWereSet) {
    const RackState state = solids_without({});
    for (const ToldShot& shot : {ToldShot().hits(3).pots(3), ToldShot().hits(3).pots(12),
                                 ToldShot().hits(12).pots(12), ToldShot().pots(0)}) {
        EXPECT_EQ(judged(state, call(3), shot).groups, shooter_has(Group::Solids));
    }
}

TEST(EightBallGroups, OpponentsBallThatWasCalledDoesNotCount) {
    expect_passes(judged(solids_without({}), call(12), ToldShot().hits(3).meets(3, 12).pots(12)),
                  Reason::NotCalled);
}

TEST(EightBallGroups, EveryFoulGivesBallInHandAnywhere) {
    const RackState state = solids_without({});
    expect_foul(judged(state, call(3), ToldShot().hits(3).pots(3).pots(0)), {Foul::Scratch});
    expect_foul(judged(state, call(3), ToldShot().hits(3).pots(3).leaves(4)), {Foul::BallOffTable});
    expect_foul(judged(state, call(3), ToldShot().cushion(0)), {Foul::NoBallHit});
    expect_foul(judged(state, call(3), ToldShot().hits(12).pots(3)), {Foul::WrongBallFirst});
    expect_foul(judged(state, call(3), ToldShot().hits(3)), {Foul::NoCushionAfterContact});
}

TEST(EightBallGroups, BallBehindTheHeadStringIsAFoulFromThereUnlessTheStringWasCrossed) {
    RackState state = solids_without({});
    state.in_hand = Zone::BehindHeadString;
    state.behind_head_string = balls({3});
    expect_foul(judged(state, call(3), ToldShot().hits(3).pots(3)), {Foul::HeadString});
    expect_continues(judged(state, call(3), ToldShot().crosses_head_string().hits(3).pots(3)));
}

TEST(EightBallGroups, ObjectBallsOffTheTableAreNotSpotted) {
    EXPECT_TRUE(judged(solids_without({}), NoCall{}, ToldShot().hits(3).leaves(3)).spotted.empty());
}

TEST(EightBallGroups, ConsecutiveFoulsAreLeftAlone) {
    RackState state = solids_without({});
    state.consecutive_fouls = {{2, 1}};
    EXPECT_EQ(judged(state, NoCall{}, ToldShot().pots(0)).consecutive_fouls,
              state.consecutive_fouls);
    EXPECT_EQ(judged(state, call(3), ToldShot().hits(3).pots(3)).consecutive_fouls,
              state.consecutive_fouls);
}

TEST(EightBallGroups, ClockRunOutIsAFoulWithBallInHand) {
    RackState state = solids_without(balls({1}));
    const Verdict verdict = eight_ball().judge_timeout(state);
    EXPECT_EQ(verdict.reason, Reason::ClockRanOut);
    EXPECT_EQ(verdict.fouls, std::vector{Foul::Clock});
    EXPECT_EQ(verdict.next_player, kOther);
    EXPECT_EQ(verdict.in_hand, Zone::Anywhere);
    EXPECT_EQ(verdict.groups, state.groups);
}

struct CallCase {
    const char* what;
    RackState state;
    model::Call said;
    bool allowed;
};

TEST(EightBallCall, OnlyABallThatIsTheShootersToPlayMayBeCalled) {
    const CallCase cases[] = {
        {"open: a solid", open_without({}), call(3), true},
        {"open: a stripe", open_without({}), call(12), true},
        {"open: the 8", open_without({}), call(8), false},
        {"own group", solids_without({}), call(3), true},
        {"own ball that is down", solids_without(balls({3})), call(3), false},
        {"the other group", solids_without({}), call(12), false},
        {"the 8 too early", solids_without({}), call(8), false},
        {"the 8 with one ball left", solids_without(kAllSolids - balls({7})), call(8), false},
        {"the 8 once the group is down", solids_without(kAllSolids), call(8), true},
        {"the cue ball", solids_without({}), call(0), false},
        {"a ball that does not exist", solids_without({}), call(255), false},
        {"the last pocket", solids_without({}), call(3, 5), true},
        {"a pocket that does not exist", solids_without({}), call(3, 6), false},
        {"nothing", solids_without({}), NoCall{}, true},
        {"a safety", solids_without({}), Safety{}, true},
    };
    for (const CallCase& each : cases) {
        EXPECT_EQ(eight_ball().is_call_allowed(each.state, {}, each.said), each.allowed)
            << each.what;
    }
}

TEST(EightBallWithoutCalls, NoBallMayBeCalledButASafetyMay) {
    const RackState state = solids_without({});
    EXPECT_FALSE(eight_ball().is_call_allowed(state, kNoCalls, call(3)));
    EXPECT_TRUE(eight_ball().is_call_allowed(state, kNoCalls, Safety{}));
    EXPECT_TRUE(eight_ball().is_call_allowed(state, kNoCalls, NoCall{}));
}

TEST(EightBallWithoutCalls, FirstBallLegallyDownSetsTheGroups) {
    const RackState open = open_without({});
    const Verdict verdict = judged(open, NoCall{}, ToldShot().hits(3).pots(12).pots(3), kNoCalls);
    expect_continues(verdict);
    EXPECT_EQ(verdict.groups, shooter_has(Group::Stripes));
    EXPECT_EQ(judged(open, NoCall{}, ToldShot().hits(8).pots(12), kNoCalls).groups, std::nullopt);
}

TEST(EightBallWithoutCalls, AnyOwnBallInAnyPocketContinues) {
    const RackState state = solids_without({});
    expect_continues(judged(state, NoCall{}, ToldShot().hits(3).pots(12, 0).pots(5, 4), kNoCalls));
    expect_passes(judged(state, NoCall{}, ToldShot().hits(3).pots(12), kNoCalls),
                  Reason::NotCalled);
    expect_passes(judged(state, Safety{}, ToldShot().hits(3).pots(3), kNoCalls), Reason::Safety);
}

TEST(EightBallWithoutCalls, TheEightInAnyPocketWins) {
    const RackState state = solids_without(kAllSolids);
    for (int pocket = 0; pocket < model::kPockets; ++pocket) {
        const Verdict verdict =
            judged(state, NoCall{}, ToldShot().hits(8).pots(8, pocket), kNoCalls);
        EXPECT_EQ(verdict.winner, kShooter) << pocket;
    }
    EXPECT_EQ(judged(state, Safety{}, ToldShot().hits(8).pots(8), kNoCalls).winner, kOther);
}

struct EightCase {
    const char* what;
    RackState state;
    model::Call said;
    ToldShot shot;
    Reason reason;
    model::Seat winner;
};

TEST(EightBallRackEnd, IsWonWithTheCalledEightAndLostWithEveryOther) {
    const RackState on_eight = solids_without(kAllSolids);
    const RackState one_left = solids_without(kAllSolids - balls({7}));
    const EightCase cases[] = {
        {"called, in its pocket", on_eight, call(8), ToldShot().hits(8).pots(8), Reason::EightWon,
         kShooter},
        {"with an opponent's ball", on_eight, call(8), ToldShot().hits(8).pots(12).pots(8),
         Reason::EightWon, kShooter},
        {"with a scratch", on_eight, call(8), ToldShot().hits(8).pots(8).pots(0),
         Reason::EightWithFoul, kOther},
        {"wrong ball first", on_eight, call(8), ToldShot().hits(12).meets(12, 8).pots(8),
         Reason::EightWithFoul, kOther},
        {"another ball off the table", on_eight, call(8), ToldShot().hits(8).pots(8).leaves(12),
         Reason::EightWithFoul, kOther},
        {"one ball too early", one_left, NoCall{}, ToldShot().hits(7).meets(7, 8).pots(8),
         Reason::EightEarly, kOther},
        {"with the last ball of the group", one_left, call(7), ToldShot().hits(7).pots(7).pots(8),
         Reason::EightEarly, kOther},
        {"on an open table", open_without({}), call(3), ToldShot().hits(3).pots(3).pots(8),
         Reason::EightEarly, kOther},
        {"in another pocket", on_eight, call(8, 1), ToldShot().hits(8).pots(8, 2),
         Reason::EightUncalled, kOther},
        {"without a call", on_eight, NoCall{}, ToldShot().hits(8).pots(8), Reason::EightUncalled,
         kOther},
        {"on a safety", on_eight, Safety{}, ToldShot().hits(8).pots(8), Reason::EightUncalled,
         kOther},
        {"off the table", on_eight, call(8), ToldShot().hits(8).leaves(8), Reason::EightOffTable,
         kOther},
        {"off the table, too early", one_left, call(7), ToldShot().hits(7).meets(7, 8).leaves(8),
         Reason::EightOffTable, kOther},
    };
    for (const EightCase& each : cases) {
        SCOPED_TRACE(each.what);
        const Verdict verdict = judged(each.state, each.said, each.shot);
        EXPECT_EQ(verdict.reason, each.reason);
        EXPECT_EQ(verdict.winner, each.winner);
        EXPECT_EQ(verdict.next_player, each.winner);
        EXPECT_FALSE(verdict.turn_continues);
        EXPECT_EQ(verdict.in_hand, Zone::None);
        EXPECT_TRUE(verdict.choices.empty());
        EXPECT_TRUE(verdict.spotted.empty());
    }
}

TEST(EightBallRackEnd, ScratchThatLeavesTheEightUpIsAFoulOnly) {
    expect_foul(judged(solids_without(kAllSolids), call(8), ToldShot().hits(8).cushion(8).pots(0)),
                {Foul::Scratch});
}

}  // namespace
}  // namespace billiards::rules
