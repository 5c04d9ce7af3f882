// Takes matches move by move; gives whether turns, racks, choices and the race go as they should.
#include "common/match/match.h"

#include "common/rules/ruleset.h"
#include "tests/common/match/match_moves.h"

#include <gtest/gtest.h>
#include <set>

namespace billiards::match {
namespace {

using model::kCueBall;
using model::kEightBall;
using model::Place;
using model::Seat;
using rules::Choice;
using rules::Phase;
using rules::Zone;

Seat other(const MatchState& match) {
    return opponent_of(match.to_act);
}

/// A ball that is down, told as part of a shot's outcome.
MatchState told_with_down(const MatchState& match, model::BallId down,
                          const rules::Verdict& verdict) {
    const MatchState ready = placed(match);
    model::Layout layout = ready.layout;
    layout.find(down)->place = Place::Pocketed;
    auto next = refold(ready, ready.to_act, shot_at(ready, 0, 0.5), layout, verdict);
    EXPECT_TRUE(next) << (next ? "" : next.error().detail);
    return std::move(next).value();
}

TEST(MatchStart, PutsTheBreakerInHandBehindTheHeadStringOfAFullRack) {
    const MatchState match = started();
    EXPECT_EQ(match.stage, Stage::Shooting);
    EXPECT_EQ(match.to_act, match.breaker);
    EXPECT_EQ(match.rack.shooter, match.breaker);
    EXPECT_EQ(match.rack.phase, Phase::Break);
    EXPECT_EQ(match.rack.in_hand, Zone::BehindHeadString);
    EXPECT_EQ(match.rack.on_table.size(), 15);
    EXPECT_EQ(match.turn, model::TurnNumber{1});
    EXPECT_EQ(match.rack_number, 1);
    expect_sound(match);
}

TEST(MatchStart, LetsTheSeedDecideWhoBreaksFirst) {
    std::set<Seat> breakers;
    for (std::uint64_t seed = 0; seed < 32; ++seed) breakers.insert(started({}, seed).breaker);
    EXPECT_EQ(breakers.size(), 2U);
    EXPECT_EQ(started({}, 5), started({}, 5));
}

TEST(MatchTurn, PlacingTheCueBallKeepsTheTurnNumberAndTheZone) {
    const MatchState match = started();
    const MatchState next = applied(match, PlaceCueBall{{-1.0, 0.1}}).next;
    EXPECT_EQ(next.turn, match.turn);
    EXPECT_EQ(next.rack.in_hand, Zone::BehindHeadString);
    EXPECT_EQ(next.layout.find(kCueBall)->position_m, base::Vec2(-1.0, 0.1));
    EXPECT_EQ(applied(next, PlaceCueBall{{-1.1, 0}}).next.layout.find(kCueBall)->position_m,
              base::Vec2(-1.1, 0.0));
    expect_sound(next);
}

TEST(MatchTurn, EveryOtherCommandRaisesTheTurnNumberByOne) {
    const MatchState match = placed(started());
    EXPECT_EQ(applied(match, shot_at(match, 0, 1.0)).next.turn.value, match.turn.value + 1);
    EXPECT_EQ(applied(match, Timeout{match.turn}).next.turn.value, match.turn.value + 1);
    EXPECT_EQ(applied(match, Concede{}).next.turn.value, match.turn.value + 1);
    const MatchState choosing = told(match, offers(other(match), {Choice::Accept}));
    EXPECT_EQ(applied(choosing, Choose{choosing.turn, Choice::Accept}).next.turn.value,
              choosing.turn.value + 1);
}

TEST(MatchTurn, ShotIsSolvedJudgedAndFoldedIn) {
    const MatchState match = placed(started());
    const Step step = applied(match, shot_at(match, 0, 1.0));
    ASSERT_TRUE(step.outcome.record && step.outcome.verdict);
    EXPECT_GT(step.outcome.record->events.size(), 20U) << "a break is no small thing";
    EXPECT_EQ(step.next.shots_played, 1);
    EXPECT_EQ(step.next.to_act, step.outcome.verdict->next_player);
    EXPECT_NE(step.next.layout, match.layout);
    expect_sound(step.next);
}

TEST(MatchTurn, FoulPutsTheCueBallInTheOpponentsHand) {
    const MatchState match = told(started(), passes_to(Seat::First));
    const MatchState next = told(match, passes_to(Seat::Second, Zone::Anywhere));
    EXPECT_EQ(next.to_act, Seat::Second);
    EXPECT_EQ(next.layout.find(kCueBall)->place, Place::InHand);
    EXPECT_EQ(next.rack.in_hand, Zone::Anywhere);
    expect_sound(next);
}

TEST(MatchTurn, BallsThatTheVerdictSpotsComeBack) {
    const MatchState match = started();
    rules::Verdict verdict = passes_to(other(match));
    verdict.spotted = {kEightBall};
    const MatchState next = told_with_down(match, kEightBall, verdict);
    EXPECT_TRUE(next.layout.on_table(kEightBall));
    EXPECT_TRUE(next.rack.on_table.contains(kEightBall));
    expect_sound(next);
}

TEST(MatchTurn, PhaseAndGroupsFollowTheVerdict) {
    const MatchState open = told(started(), passes_to(Seat::First));
    EXPECT_EQ(open.rack.phase, Phase::Open);
    rules::Verdict groups = passes_to(Seat::First);
    groups.groups = {{rules::Group::Stripes, rules::Group::Solids}};
    groups.phase = Phase::Groups;
    const MatchState grouped = told(open, groups);
    EXPECT_EQ(grouped.rack.phase, Phase::Groups);
    EXPECT_EQ(grouped.rack.groups, groups.groups);
}

TEST(MatchTimeout, BeforeTheBreakTheOtherPlayerBreaks) {
    const MatchState match = placed(started());
    const Step step = applied(match, Timeout{match.turn});
    EXPECT_EQ(step.next.breaker, other(match));
    EXPECT_EQ(step.next.to_act, other(match));
    EXPECT_EQ(step.next.rack.phase, Phase::Break);
    EXPECT_EQ(step.next.rack.in_hand, Zone::BehindHeadString);
    EXPECT_EQ(step.next.layout.find(kCueBall)->place, Place::InHand);
    EXPECT_EQ(step.next.shots_played, 0);
    ASSERT_TRUE(step.outcome.verdict);
    EXPECT_EQ(step.outcome.verdict->fouls, std::vector{rules::Foul::Clock});
    EXPECT_FALSE(step.outcome.record);
    expect_sound(step.next);
}

TEST(MatchTimeout, AfterTheBreakTheOpponentHasTheCueBallInHandAnywhere) {
    const MatchState match = told(started(), passes_to(Seat::First));
    const MatchState next = applied(match, Timeout{match.turn}).next;
    EXPECT_EQ(next.to_act, Seat::Second);
    EXPECT_EQ(next.rack.in_hand, Zone::Anywhere);
    EXPECT_EQ(next.rack.phase, Phase::Open);
    EXPECT_EQ(next.breaker, match.breaker);
    expect_sound(next);
}

TEST(MatchTimeout, ChoiceThatRunsOutTakesTheFirstOneListed) {
    const MatchState match = started();
    const MatchState choosing =
        told(match, offers(other(match), {Choice::RebreakSelf, Choice::Accept}));
    const Step step = applied(choosing, Timeout{choosing.turn});
    EXPECT_EQ(step.next, applied(choosing, Choose{choosing.turn, Choice::RebreakSelf}).next);
    EXPECT_FALSE(step.outcome.verdict);
}

TEST(MatchChoice, WaitsWithTheVerdictUntilItIsTaken) {
    const MatchState match = placed(started());
    const rules::Verdict verdict = offers(other(match), {Choice::Accept, Choice::RebreakSelf});
    const MatchState choosing = told(match, verdict);
    EXPECT_EQ(choosing.stage, Stage::Choosing);
    ASSERT_TRUE(choosing.pending);
    EXPECT_EQ(choosing.pending->verdict, verdict);
    EXPECT_EQ(choosing.pending->before, match.rack);
    EXPECT_EQ(choosing.to_act, other(match));
    expect_sound(choosing);
}

TEST(MatchChoice, AcceptPlaysOnFromThePosition) {
    const MatchState match = placed(started());
    const MatchState choosing = told(match, offers(other(match), {Choice::Accept}));
    const MatchState next = applied(choosing, Choose{choosing.turn, Choice::Accept}).next;
    EXPECT_EQ(next.stage, Stage::Shooting);
    EXPECT_EQ(next.layout, choosing.layout);
    EXPECT_EQ(next.rack.phase, Phase::Open);
    EXPECT_EQ(next.to_act, other(match));
    expect_sound(next);
}

TEST(MatchChoice, RebreakRacksTheSameRackAgainForTheChosenBreaker) {
    const MatchState match = started();
    const std::vector<Choice> choices{Choice::Accept, Choice::RebreakSelf, Choice::RebreakOpponent};
    const MatchState choosing = told_with_down(match, {3}, offers(other(match), choices));
    struct {
        Choice choice;
        Seat breaker;
    } const cases[] = {{Choice::RebreakSelf, other(match)},
                       {Choice::RebreakOpponent, match.to_act}};
    for (const auto& each : cases) {
        const MatchState next = applied(choosing, Choose{choosing.turn, each.choice}).next;
        EXPECT_EQ(next.breaker, each.breaker);
        EXPECT_EQ(next.to_act, each.breaker);
        EXPECT_EQ(next.rack.phase, Phase::Break);
        EXPECT_EQ(next.rack_number, match.rack_number);
        EXPECT_EQ(next.layout, match.layout);
        expect_sound(next);
    }
}

TEST(MatchChoice, SpotEightPutsItBackOnTheTable) {
    const MatchState match = started();
    const MatchState choosing = told_with_down(
        match, kEightBall, offers(match.to_act, {Choice::SpotEight, Choice::RebreakSelf}));
    EXPECT_FALSE(choosing.rack.on_table.contains(kEightBall));
    expect_sound(choosing);
    const MatchState next = applied(choosing, Choose{choosing.turn, Choice::SpotEight}).next;
    EXPECT_TRUE(next.rack.on_table.contains(kEightBall));
    EXPECT_EQ(next.to_act, match.to_act);
    EXPECT_EQ(next.rack.in_hand, Zone::None);
    expect_sound(next);
}

/// Of a break that drives these object balls to cushions, and the 8 off the table.
rules::Verdict judged_without_eight(const MatchState& match, model::BallSet driven) {
    rules::Facts facts;
    facts.first_contacts = {{1}};
    facts.off_table = {kEightBall};
    facts.driven_to_cushion = driven | facts.off_table;
    facts.driven_after_contact = facts.driven_to_cushion;
    return rules::ruleset_of(rules::Game::EightBall).judge(match.rack, {}, model::NoCall{}, facts);
}

TEST(MatchChoice, EightThatLeftTheTableIsSpottedOnceByWhateverPlaysOn) {
    const MatchState match = started();
    const model::BallSet three{{1}, {2}, {3}};
    const struct {
        model::BallSet driven;
        Choice choice;
    } cases[] = {{three, Choice::Accept},
                 {three, Choice::BallInHandBehindHeadString},
                 {{}, Choice::Accept},
                 {{}, Choice::RebreakSelf}};
    for (const auto& each : cases) {
        const rules::Verdict verdict = judged_without_eight(match, each.driven);
        const MatchState choosing = told_with_down(match, kEightBall, verdict);
        ASSERT_EQ(choosing.stage, Stage::Choosing);
        EXPECT_FALSE(choosing.rack.on_table.contains(kEightBall));
        const MatchState next = applied(choosing, Choose{choosing.turn, each.choice}).next;
        EXPECT_EQ(next.rack.on_table.size(), 15);
        expect_sound(next);
    }
}

TEST(MatchChoice, CueBallInHandBehindTheHeadStringIsLifted) {
    const MatchState match = started();
    const MatchState choosing =
        told(match, offers(other(match), {Choice::Accept, Choice::BallInHandBehindHeadString}));
    const Choose choose{choosing.turn, Choice::BallInHandBehindHeadString};
    const MatchState next = applied(choosing, choose).next;
    EXPECT_EQ(next.rack.in_hand, Zone::BehindHeadString);
    EXPECT_EQ(next.layout.find(kCueBall)->place, Place::InHand);
    expect_sound(next);
}

TEST(MatchRace, WonRackIsCountedAndAFreshOneRacked) {
    const MatchState match = started(race_to(2));
    const MatchState next = told(match, won_by(Seat::Second));
    EXPECT_EQ(next.racks_won[Seat::First], 0);
    EXPECT_EQ(next.racks_won[Seat::Second], 1);
    EXPECT_EQ(next.rack_number, 2);
    EXPECT_EQ(next.rack.phase, Phase::Break);
    EXPECT_EQ(next.rack.groups, std::nullopt);
    EXPECT_EQ(next.stage, Stage::Shooting);
    EXPECT_NE(next.layout, match.layout) << "another rack lies in another order";
    expect_sound(next);
}

TEST(MatchRace, RackOfStraightPoolStartsWithoutPointsAndFouls) {
    Settings settings = race_to(2);
    settings.game = rules::Game::StraightPool;
    const MatchState match = started(settings);
    rules::Verdict pots = passes_to(Seat::First);
    pots.phase = Phase::Groups;
    pots.score_change = {{7, -1}};
    pots.consecutive_fouls = {{0, 1}};
    const MatchState scored = told(told(match, pots), pots);
    EXPECT_EQ(scored.rack.scores, (model::PerSeat<int>{{14, -2}}));
    const MatchState next = told(scored, won_by(Seat::First));
    EXPECT_EQ(next.racks_won[Seat::First], 1);
    EXPECT_EQ(next.rack.scores, model::PerSeat<int>{});
    EXPECT_EQ(next.rack.consecutive_fouls, model::PerSeat<int>{});
    expect_sound(next);
}

TEST(MatchRace, EndsWhenOneSeatHasWonItsRacks) {
    MatchState match = started(race_to(2));
    for (const Seat winner : {Seat::First, Seat::Second, Seat::First}) {
        EXPECT_EQ(match.stage, Stage::Shooting);
        match = told(match, won_by(winner));
    }
    EXPECT_EQ(match.stage, Stage::Over);
    EXPECT_EQ(match.winner, Seat::First);
    EXPECT_EQ(match.racks_won[Seat::First], 2);
    EXPECT_EQ(match.racks_won[Seat::Second], 1);
    EXPECT_EQ(match.rack.in_hand, Zone::None);
    expect_sound(match);
}

TEST(MatchRace, ConcessionEndsTheMatchForTheOther) {
    for (const Seat seat : model::kSeats) {
        auto step = apply(started(race_to(5)), seat, Concede{});
        ASSERT_TRUE(step);
        EXPECT_EQ(step->next.stage, Stage::Over);
        EXPECT_EQ(step->next.winner, opponent_of(seat));
        expect_sound(step->next);
    }
}

TEST(MatchRace, ConcessionEndsAPendingChoice) {
    const MatchState match = started();
    const MatchState choosing = told(match, offers(other(match), {Choice::Accept}));
    expect_sound(applied(choosing, Concede{}).next);
}

std::vector<Seat> breakers(BreakOrder order, const std::vector<Seat>& winners) {
    MatchState match = started(race_to(9, order), 3);
    std::vector<Seat> seats{match.breaker};
    for (const Seat winner : winners) {
        match = told(match, won_by(winner));
        seats.push_back(match.breaker);
    }
    return seats;
}

TEST(MatchBreakOrder, AlternatesOrFollowsTheWinnerOrTheLoser) {
    const std::vector<Seat> winners{Seat::First, Seat::First, Seat::Second, Seat::First};
    const Seat first = started({}, 3).breaker;
    const Seat second = opponent_of(first);
    EXPECT_EQ(breakers(BreakOrder::Alternate, winners),
              (std::vector{first, second, first, second, first}));
    EXPECT_EQ(breakers(BreakOrder::Winner, winners),
              (std::vector{first, Seat::First, Seat::First, Seat::Second, Seat::First}));
    EXPECT_EQ(breakers(BreakOrder::Loser, winners),
              (std::vector{first, Seat::Second, Seat::Second, Seat::First, Seat::Second}));
}

TEST(MatchBreakOrder, AlternationIsNotShiftedByABreakThatChangedHands) {
    const MatchState match = started(race_to(9), 3);
    const MatchState swapped = applied(match, Timeout{match.turn}).next;
    ASSERT_EQ(swapped.breaker, opponent_of(match.breaker));
    EXPECT_EQ(told(swapped, won_by(Seat::First)).breaker, opponent_of(match.breaker));
}

TEST(MatchPhysics, PresetsAreTheEnginesOwn) {
    EXPECT_EQ(parameters_of(PhysicsPreset::Realistic), physics::realistic_parameters());
    EXPECT_EQ(parameters_of(PhysicsPreset::Classic), physics::classic_parameters());
}

}  // namespace
}  // namespace billiards::match
