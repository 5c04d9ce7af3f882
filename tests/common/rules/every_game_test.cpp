// Takes random shots at random racks of every game; gives whether each verdict agrees with itself.
#include "common/rules/ruleset.h"
#include "tests/common/rules/told_shot.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

using base::Random;

constexpr int kShots = 20000;

int any_of(Random& random, int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low + 1)));
}

bool chance(Random& random, int in) {
    return any_of(random, 1, in) == 1;
}

int balls_of(Game game) {
    return game == Game::NineBall ? 9 : game == Game::TenBall ? 10 : 15;
}

/// Somewhere in a rack. The ball that wins is up, as it is in every rack that is not over.
RackState random_state(Game game, Random& random) {
    RackState state;
    const bool eight_ball = game == Game::EightBall;
    const auto phases = eight_ball ? std::vector{Phase::Break, Phase::Open, Phase::Groups}
                                   : std::vector{Phase::Break, Phase::AfterBreak, Phase::Groups};
    state.phase = phases[random.below(phases.size())];
    for (int ball = 1; ball <= balls_of(game); ++ball) {
        const bool up = state.phase == Phase::Break || !chance(random, 3);
        if (up) state.on_table.insert(ToldShot::id(ball));
    }
    state.on_table.insert(ToldShot::id(eight_ball ? 8 : balls_of(game)));
    state.shooter = model::kSeats[random.below(2)];
    if (eight_ball && state.phase == Phase::Groups)
        state.groups = {{Group::Solids, Group::Stripes}};
    state.in_hand = static_cast<Zone>(random.below(3));
    state.consecutive_fouls = {{any_of(random, 0, 2), any_of(random, 0, 2)}};
    state.push_out_allowed = state.phase == Phase::AfterBreak;
    state.scores = {{any_of(random, -5, 99), any_of(random, -5, 99)}};
    return state;
}

ToldShot random_shot(const RackState& state, Random& random) {
    std::vector<int> up{0};
    state.on_table.for_each([&](model::BallId ball) { up.push_back(ball.number); });
    ToldShot shot;
    for (int i = any_of(random, 0, 8); i > 0 && up.size() > 1; --i) {
        const std::size_t which = random.below(up.size());
        const int ball = up[which];
        switch (random.below(4)) {
            case 0:
                shot.cushion(ball);
                break;
            case 1:
                shot.hits(up[1]);
                break;
            case 2:
                shot.pots(ball, any_of(random, 0, 5));
                up.erase(up.begin() + static_cast<std::ptrdiff_t>(which));
                break;
            default:
                if (!chance(random, 4)) break;
                shot.leaves(ball);
                up.erase(up.begin() + static_cast<std::ptrdiff_t>(which));
        }
        if (ball == 0) break;
    }
    return shot;
}

model::Call random_call(Random& random) {
    switch (random.below(4)) {
        case 0:
            return model::NoCall{};
        case 1:
            return model::Safety{};
        case 2:
            return model::PushOut{};
        default:
            return call(any_of(random, 1, 15), any_of(random, 0, 5));
    }
}

void expect_sound(const RackState& state, const Verdict& verdict) {
    EXPECT_TRUE(std::ranges::is_sorted(verdict.fouls));
    EXPECT_EQ(std::ranges::adjacent_find(verdict.fouls), verdict.fouls.end());
    EXPECT_TRUE(std::ranges::is_sorted(verdict.spotted));
    EXPECT_EQ(verdict.chooser.has_value(), !verdict.choices.empty());
    EXPECT_EQ(verdict.chooser.value_or(verdict.next_player), verdict.next_player);
    const bool stays = verdict.next_player == state.shooter && !verdict.chooser && !verdict.winner;
    EXPECT_EQ(verdict.turn_continues, stays);
    if (verdict.winner) {
        EXPECT_EQ(*verdict.winner, verdict.next_player);
        EXPECT_TRUE(verdict.spotted.empty() && verdict.choices.empty());
        EXPECT_EQ(verdict.in_hand, Zone::None);
        EXPECT_EQ(verdict.rerack, Rerack::None);
    }
    const model::Seat other = opponent_of(state.shooter);
    EXPECT_EQ(verdict.consecutive_fouls[other], state.consecutive_fouls[other]);
    EXPECT_EQ(verdict.score_change[other], 0);
}

/// Only a rack that goes on needs its cue ball and the ball that wins.
void expect_playable(Game game, const RackState& state, const Facts& facts,
                     const Verdict& verdict) {
    if (verdict.winner) return;
    EXPECT_TRUE(!facts.cue_ball_lost || verdict.in_hand != Zone::None);
    model::BallSet after = state.on_table - fallen_balls(facts) - facts.off_table;
    for (const model::BallId ball : verdict.spotted) {
        EXPECT_FALSE(after.contains(ball));
        after.insert(ball);
    }
    const bool choosing = !verdict.choices.empty();  // The 8 may come back with the choice.
    const bool racked = verdict.rerack != Rerack::None;
    EXPECT_TRUE(game == Game::Practice || choosing || racked || !after.empty());
    EXPECT_TRUE(game != Game::NineBall || after.contains(ToldShot::id(9)));
    EXPECT_TRUE(game != Game::TenBall || after.contains(ToldShot::id(10)));
    EXPECT_TRUE(game != Game::StraightPool || racked || after.size() > 1);
}

class EveryGame : public testing::TestWithParam<Game> {};

INSTANTIATE_TEST_SUITE_P(Games, EveryGame,
                         testing::Values(Game::EightBall, Game::NineBall, Game::TenBall,
                                         Game::StraightPool, Game::Practice));

TEST_P(EveryGame, GivesVerdictsThatAgreeWithThemselvesAndLeaveARackThatCanBePlayed) {
    Random random(3);
    const Ruleset& rules = ruleset_of(GetParam());
    for (int i = 0; i < kShots && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        const RackState state = random_state(GetParam(), random);
        const Facts facts = random_shot(state, random).facts();
        const Verdict verdict = rules.judge(state, {}, random_call(random), facts);
        expect_sound(state, verdict);
        expect_playable(GetParam(), state, facts, verdict);
        for (const Choice choice : verdict.choices) {
            const Resolution resolution = rules.resolve(state, verdict, choice);
            const bool lost = facts.cue_ball_lost && !resolution.rerack;
            EXPECT_TRUE(!lost || resolution.in_hand != Zone::None);
        }
    }
}

TEST_P(EveryGame, GivesVerdictsOnTheClockThatAgreeWithThemselves) {
    Random random(4);
    for (int i = 0; i < kShots / 10 && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        const RackState state = random_state(GetParam(), random);
        const Verdict verdict = ruleset_of(GetParam()).judge_timeout(state);
        expect_sound(state, verdict);
        expect_playable(GetParam(), state, {}, verdict);
    }
}

TEST_P(EveryGame, RulesOnACallThatMayNotBeSaidAsIfItWereUnsaid) {
    Random random(5);
    const Ruleset& rules = ruleset_of(GetParam());
    int unsaid = 0;
    for (int i = 0; i < kShots && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        const RackState state = random_state(GetParam(), random);
        const Facts facts = random_shot(state, random).facts();
        const model::Call said = random_call(random);
        if (rules.is_call_allowed(state, {}, said)) continue;
        ++unsaid;
        EXPECT_EQ(rules.judge(state, {}, said, facts),
                  rules.judge(state, {}, model::NoCall{}, facts));
    }
    EXPECT_GT(unsaid, kShots / 10);
}

}  // namespace
}  // namespace billiards::rules
