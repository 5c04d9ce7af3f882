// Holds the cheap player against the rules: whatever it decides is taken.
#include "tools/player/simple_shot.h"

#include "common/match/match.h"

#include <gtest/gtest.h>
#include <utility>

namespace billiards::tools {
namespace {

TEST(SimpleShot, IsLegalThroughoutMatches) {
    int shots = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        base::Random random(seed);
        match::MatchState state = match::start({}, seed).value();
        for (int i = 0; i < 400 && state.stage != match::Stage::Over; ++i) {
            const match::Command command = simple_shot(state, random);
            auto step = match::apply(state, state.to_act, command);
            ASSERT_TRUE(step) << step.error().detail;
            state = std::move(step).value().next;
        }
        shots += state.shots_played;
    }
    EXPECT_GT(shots, 500);
}

TEST(SimpleShot, EndsAMatchOfEveryGame) {
    for (const rules::Game game :
         {rules::Game::EightBall, rules::Game::NineBall, rules::Game::TenBall,
          rules::Game::StraightPool, rules::Game::Practice}) {
        match::Settings settings;
        settings.game = game;
        settings.race_to = 1;
        settings.options.target_points = 10;
        base::Random random(1);
        match::MatchState state = match::start(settings, 1).value();
        while (state.stage != match::Stage::Over) {
            ASSERT_LT(state.shots_played, 3000) << "game " << static_cast<int>(game);
            auto step = match::apply(state, state.to_act, simple_shot(state, random));
            ASSERT_TRUE(step) << step.error().detail;
            state = std::move(step).value().next;
        }
    }
}

TEST(SimpleShot, FollowsFromStateAndSeed) {
    match::MatchState state = match::start({}, 1).value();
    base::Random one(3);
    base::Random same(3);
    EXPECT_EQ(simple_shot(state, one), simple_shot(state, same));
}

}  // namespace
}  // namespace billiards::tools
