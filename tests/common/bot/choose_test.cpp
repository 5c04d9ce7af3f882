// Takes matches; gives whether the bot's commands are legal, sensible, the same every time, and
// bring a match to its end.
#include "common/bot/choose.h"

#include "tests/common/match/layouts.h"
#include "tests/common/match/match_moves.h"

#include <gtest/gtest.h>

namespace billiards::bot {
namespace {

using base::Vec2;
using match::id;
using match::MatchState;
using model::Seat;
using rules::Choice;
using rules::Zone;

constexpr int kMaxShotsPerRack = 120;

/// A match after the break where only these balls are up, First to act with the solids.
MatchState with_only(const std::vector<std::pair<int, Vec2>>& up, Zone in_hand = Zone::None) {
    const MatchState start = match::placed(match::started(match::race_to(2)));
    model::Layout layout = start.layout;
    for (model::PlacedBall& placed : layout.balls) placed.place = model::Place::Pocketed;
    for (const auto& [ball, position_m] : up) {
        *layout.find(id(ball)) = {id(ball), model::Place::OnTable, position_m};
    }
    rules::Verdict verdict = match::passes_to(Seat::First, in_hand);
    verdict.groups = {{rules::Group::Solids, rules::Group::Stripes}};
    auto next = match::refold(start, start.to_act, match::shot_at(start, 0, 0.5), layout, verdict);
    EXPECT_TRUE(next) << (next ? "" : next.error().detail);
    return std::move(next).value();
}

match::Command chosen(const MatchState& state) {
    base::Random random(1);
    return choose(state, random);
}

/// The ruling on the shot that the bot takes, after its placement where it has one.
rules::Verdict verdict_of_choice(MatchState state) {
    match::Step step = match::applied(state, chosen(state));
    if (!step.outcome.verdict) step = match::applied(step.next, chosen(step.next));
    EXPECT_TRUE(step.outcome.verdict.has_value());
    return step.outcome.verdict.value_or(rules::Verdict{});
}

TEST(Bot, PlacesTheCueBallBeforeTheBreakAndThenBreaksLegally) {
    const MatchState match = match::started();
    ASSERT_TRUE(std::holds_alternative<match::PlaceCueBall>(chosen(match)));
    const MatchState ready = match::applied(match, chosen(match)).next;
    const match::Step step = match::applied(ready, chosen(ready));
    ASSERT_TRUE(step.outcome.verdict);
    EXPECT_NE(step.outcome.verdict->reason, rules::Reason::IllegalBreak);
}

TEST(Bot, PotsAHangingBallAndCallsIt) {
    const MatchState match =
        with_only({{0, {0.6, 0.0}}, {3, {1.1, -0.5}}, {8, {-1.0, 0.4}}, {12, {-1.0, -0.4}}});
    const auto shot = std::get<match::TakeShot>(chosen(match));
    EXPECT_EQ(shot.call, (model::Call{model::CalledBall{id(3), {2}}}));
    EXPECT_EQ(verdict_of_choice(match).reason, rules::Reason::LegalPot);
}

TEST(Bot, DropsABallThatHangsInTheJaws) {
    for (const Vec2 jaws_m : {Vec2{1.2426, 0.6398}, Vec2{-1.2535, 0.6019}, Vec2{-0.0269, 0.6343}}) {
        const MatchState match = with_only({{8, jaws_m}, {12, {0.5, -0.4}}}, Zone::Anywhere);
        EXPECT_EQ(verdict_of_choice(match).reason, rules::Reason::EightWon) << jaws_m.x;
    }
}

TEST(Bot, MakesNearlyEveryCutThatItSeesInSpiteOfThrow) {
    constexpr int kShots = 60;
    int made = 0;
    base::Random random(4);
    for (int i = 0; i < kShots; ++i) {
        const Vec2 cue_ball_m{random.uniform(-1.0, -0.4), random.uniform(-0.5, 0.5)};
        const Vec2 ball_m{random.uniform(0.0, 0.6), random.uniform(-0.5, 0.5)};
        const MatchState match =
            with_only({{0, cue_ball_m}, {3, ball_m}, {8, {1.2, 0.0}}, {12, {1.2, 0.2}}});
        if (verdict_of_choice(match).reason == rules::Reason::LegalPot) ++made;
    }
    EXPECT_GE(made, 57);
}

TEST(Bot, WinsWithTheEightWhenItsGroupIsDown) {
    const MatchState match = with_only({{0, {0.6, 0.0}}, {8, {1.1, -0.5}}, {12, {-1.0, -0.4}}});
    const rules::Verdict verdict = verdict_of_choice(match);
    EXPECT_EQ(verdict.reason, rules::Reason::EightWon);
    EXPECT_EQ(verdict.winner, Seat::First);
}

TEST(Bot, PlaysALegalSafetyWhereItSeesNoPot) {
    // The 3 is hidden from every pocket by the balls around it.
    const MatchState match = with_only({{0, {-0.5, 0.0}},
                                        {3, {0.3, 0.0}},
                                        {12, {0.3, 0.058}},
                                        {13, {0.3, -0.058}},
                                        {14, {0.36, 0.02}},
                                        {15, {0.36, -0.04}},
                                        {8, {-1.1, 0.5}}});
    EXPECT_EQ(verdict_of_choice(match).reason, rules::Reason::Safety);
}

TEST(Bot, SetsTheCueBallDownWhereItHelps) {
    for (const Zone zone : {Zone::Anywhere, Zone::BehindHeadString}) {
        const MatchState match =
            with_only({{3, {0.2, -0.3}}, {8, {1.0, 0.5}}, {12, {1.0, 0.0}}}, zone);
        ASSERT_TRUE(std::holds_alternative<match::PlaceCueBall>(chosen(match)));
        EXPECT_EQ(verdict_of_choice(match).reason, rules::Reason::LegalPot);
    }
}

struct ChoiceCase {
    const char* what;
    std::vector<Choice> offered;
    Choice taken;
};

TEST(Bot, TakesASensibleChoice) {
    const ChoiceCase cases[] = {
        {"illegal break",
         {Choice::Accept, Choice::RebreakSelf, Choice::RebreakOpponent},
         Choice::RebreakSelf},
        {"8 on the break", {Choice::SpotEight, Choice::RebreakSelf}, Choice::SpotEight},
        {"break foul, nothing to pot",
         {Choice::Accept, Choice::BallInHandBehindHeadString},
         Choice::BallInHandBehindHeadString},
        {"nothing it prefers", {Choice::RebreakOpponent}, Choice::RebreakOpponent},
    };
    const MatchState match = match::started();
    for (const ChoiceCase& each : cases) {
        const auto verdict = match::offers(opponent_of(match.to_act), each.offered);
        const MatchState choosing = match::told(match, verdict);
        EXPECT_EQ(std::get<match::Choose>(chosen(choosing)).choice, each.taken) << each.what;
    }
}

TEST(Bot, ChoosesTheSameForTheSameMatchAndRandomNumbers) {
    const MatchState match = match::placed(match::started());
    EXPECT_EQ(chosen(match), chosen(match));
    const MatchState later =
        with_only({{0, {0.6, 0.0}}, {3, {0.4, -0.3}}, {8, {-1.0, 0.4}}, {12, {-1.0, -0.4}}});
    EXPECT_EQ(chosen(later), chosen(later));
}

TEST(Bot, GivesALegalCommandWhereverTheBallsLie) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        base::Random random(seed);
        std::vector<std::pair<int, Vec2>> up;
        for (const model::PlacedBall& placed : match::random_layout(seed).balls) {
            const bool stays = placed.ball == model::kEightBall || random.below(3) == 0;
            if (stays) up.emplace_back(placed.ball.number, placed.position_m);
        }
        const Zone zone = random.below(2) == 0 ? Zone::Anywhere : Zone::BehindHeadString;
        const MatchState in_hand = with_only(up, zone);
        auto placed = match::apply(in_hand, in_hand.to_act, choose(in_hand, random));
        ASSERT_TRUE(placed) << seed << ": " << placed.error().detail;
        auto shot = match::apply(placed->next, in_hand.to_act, choose(placed->next, random));
        ASSERT_TRUE(shot) << seed << ": " << shot.error().detail;
        EXPECT_TRUE(shot->outcome.verdict.has_value());
    }
}

/// Every command that the bot gives is applied, and told again by its journal entry; the match is
/// over when this returns, or a failure is noted.
MatchState played_out(const match::Settings& settings, std::uint64_t seed) {
    base::Random random(seed);
    MatchState state = match::started(settings, seed);
    while (state.stage != match::Stage::Over) {
        const int shots_allowed = kMaxShotsPerRack * state.rack_number;
        if (state.shots_played > shots_allowed) {
            ADD_FAILURE() << "rack " << state.rack_number << " does not end";
            return state;
        }
        const match::Command command = choose(state, random);
        auto step = match::apply(state, state.to_act, command);
        if (!step) {
            ADD_FAILURE() << "seed " << seed << ": " << step.error().detail;
            return state;
        }
        EXPECT_EQ(match::folded_again(state, state.to_act, command, step->outcome), step->next);
        match::expect_sound(step->next);
        state = std::move(step).value().next;
    }
    return state;
}

TEST(BotMatch, IsPlayedToItsEndWithLegalCommandsOnly) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const MatchState over = played_out(match::race_to(1), seed);
        EXPECT_EQ(over.stage, match::Stage::Over) << seed;
    }
}

TEST(BotMatch, IsPlayedToItsEndAtEveryGame) {
    for (const rules::Game game : {rules::Game::NineBall, rules::Game::TenBall,
                                   rules::Game::StraightPool, rules::Game::Practice}) {
        match::Settings settings = match::race_to(1);
        settings.game = game;
        settings.options.target_points = 20;
        const MatchState over = played_out(settings, 4);
        EXPECT_EQ(over.stage, match::Stage::Over);
        EXPECT_EQ(over.winner.has_value(), game != rules::Game::Practice);
    }
}

TEST(BotMatch, GoesOverSeveralRacksUntilOneSeatHasWonTheRace) {
    const MatchState over = played_out(match::race_to(3), 11);
    ASSERT_TRUE(over.winner.has_value());
    EXPECT_EQ(over.racks_won[*over.winner], 3);
    EXPECT_GE(over.rack_number, 3);
}

TEST(BotMatch, IsPlayedToItsEndWithoutCallsAndWithTheOriginalPhysics) {
    match::Settings settings = match::race_to(1);
    settings.options.call = false;
    EXPECT_EQ(played_out(settings, 1).stage, match::Stage::Over);
    settings.physics = match::PhysicsPreset::Classic;
    settings.table = model::TableSize::SevenFoot;
    EXPECT_EQ(played_out(settings, 2).stage, match::Stage::Over);
}

}  // namespace
}  // namespace billiards::bot
