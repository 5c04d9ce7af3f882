// Takes random seeds; gives whether matches of random commands, legal and illegal, keep what every
// match keeps, and whether the journal alone tells them again.
#include "common/base/random.h"
#include "common/match/match.h"
#include "tests/common/match/match_moves.h"
#include "tests/common/match/random_play.h"
#include "tests/common/match/soundness.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace billiards::match {
namespace {

using base::Random;
using base::Vec2;
using model::Seat;

constexpr int kCommands = 80;

bool chance(Random& random, int in) {
    return random.below(static_cast<std::uint64_t>(in)) == 0;
}

Settings random_settings(Random& random) {
    const auto game = static_cast<rules::Game>(random.below(5));
    Settings settings = short_settings(game, random);
    settings.race_to = 1 + static_cast<int>(random.below(3));
    if (chance(random, 4)) settings.extension_s = 0.0;
    if (chance(random, 4)) settings.shot_clock_s = 0.0;
    return settings;
}

model::Call random_call(Random& random) {
    if (chance(random, 6)) return model::Safety{};
    if (chance(random, 6)) return model::PushOut{};
    if (chance(random, 3)) return model::NoCall{};
    return model::CalledBall{{static_cast<std::uint8_t>(random.below(17))},
                             {static_cast<std::uint8_t>(random.below(7))}};
}

model::Shot random_shot(Random& random) {
    model::Shot shot;
    shot.angle_rad = random.uniform(-3.2, 3.2);
    shot.power = random.uniform(-0.05, 1.05);
    if (chance(random, 2)) shot.tip_left = random.uniform(-0.4, 0.4);
    if (chance(random, 2)) shot.tip_up = random.uniform(-0.4, 0.4);
    if (chance(random, 8)) shot.elevation_rad = random.uniform(0.0, 1.0);
    return shot;
}

Vec2 random_position(Random& random) {
    return {random.uniform(-1.3, 1.3), random.uniform(-0.7, 0.7)};
}

/// Any command, whatever is due.
Command random_command(model::TurnNumber turn, Random& random) {
    switch (random.below(std::variant_size_v<Command>)) {
        case 0:
            return PlaceCueBall{random_position(random)};
        case 1:
            return TakeShot{turn, random_shot(random), random_call(random)};
        case 2:
            return Choose{turn, static_cast<rules::Choice>(random.below(7))};
        case 3:
            return Timeout{turn};
        case 4:
            return chance(random, 5) ? Command(Concede{}) : Command(Timeout{turn});
        case 5:
            return Extend{turn};
        case 6:
            return Offer{turn, static_cast<OfferKind>(random.below(2))};
        case 7:
            return Answer{turn, chance(random, 2)};
        case 8:
            return ClaimStalemate{turn};
        case 9:
            return SpotNearest{turn};
        case 10:
            return PlaceBall{{static_cast<std::uint8_t>(random.below(17))},
                             random_position(random)};
        case 11:
            return Undo{};
        case 12:
            return Repeat{};
        default:
            return Rerack{};
    }
}

/// Mostly what is due, sometimes anything.
Command next_command(const MatchState& match, Random& random) {
    model::TurnNumber turn = match.turn;
    if (chance(random, 20)) ++turn.value;
    if (chance(random, 2)) return random_command(turn, random);
    if (match.offer && chance(random, 2)) return Answer{turn, chance(random, 2)};
    const bool aims = match.stage == Stage::Shooting && match.layout.on_table(model::kCueBall);
    if (aims && chance(random, 2)) {
        return TakeShot{turn, random_shot(random), random_call(random)};
    }
    return random_legal_command(match, random);
}

/// How often a match of random commands accepted and refused one.
struct Tally {
    int accepted = 0;
    int refused = 0;
};

Tally play_random_match(std::uint64_t seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    MatchState match = started(random_settings(random), seed);
    Tally tally;
    for (int i = 0; i < kCommands && match.stage != Stage::Over; ++i) {
        const Command command = next_command(match, random);
        const Seat seat = chance(random, 10) ? opponent_of(match.to_act) : match.to_act;
        const MatchState before = match;
        auto step = apply(match, seat, command);
        EXPECT_EQ(match, before);
        if (!step) {
            EXPECT_NE(step.error().code, RefusalCode::Unsolvable) << step.error().detail;
            EXPECT_FALSE(step.error().detail.empty());
            ++tally.refused;
            continue;
        }
        ++tally.accepted;
        EXPECT_EQ(first_fault(before, seat, command, *step), std::nullopt) << command.index();
        match = std::move(step).value().next;
    }
    return tally;
}

TEST(RandomMatch, KeepsItsInvariantsAndIsToldAgainByItsJournal) {
    const bool held = rc::check([](std::uint64_t seed) {
        play_random_match(seed);
        RC_ASSERT(!testing::Test::HasFailure());
    });
    EXPECT_TRUE(held);
}

TEST(RandomMatch, SeesAcceptedAndRefusedCommandsAlike) {
    Tally total;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Tally tally = play_random_match(seed);
        total.accepted += tally.accepted;
        total.refused += tally.refused;
    }
    EXPECT_GT(total.accepted, 150);
    EXPECT_GT(total.refused, 100);
}

class CompleteMatch : public testing::TestWithParam<rules::Game> {};

TEST_P(CompleteMatch, EndsDecidedAndSound) {
    constexpr std::uint64_t kMatches = 200;
    for (std::uint64_t seed = 0; seed < kMatches; ++seed) {
        EXPECT_EQ(play_match(GetParam(), seed).fault, std::nullopt) << "match " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Games, CompleteMatch,
                         testing::Values(rules::Game::EightBall, rules::Game::NineBall,
                                         rules::Game::TenBall, rules::Game::StraightPool,
                                         rules::Game::Practice));

}  // namespace
}  // namespace billiards::match
