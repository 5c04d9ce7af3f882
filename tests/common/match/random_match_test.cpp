// Takes random seeds; gives whether matches of random commands, legal and illegal, keep what every
// match keeps, and whether the journal alone tells them again.
#include "common/base/random.h"
#include "common/match/match.h"
#include "tests/common/match/match_moves.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace billiards::match {
namespace {

using base::Random;
using model::Seat;

constexpr int kCommands = 80;

bool chance(Random& random, int in) {
    return random.below(static_cast<std::uint64_t>(in)) == 0;
}

Settings random_settings(Random& random) {
    Settings settings;
    settings.options.call = !chance(random, 3);
    settings.table = static_cast<model::TableSize>(random.below(3));
    settings.physics = static_cast<PhysicsPreset>(random.below(2));
    settings.break_order = static_cast<BreakOrder>(random.below(3));
    settings.race_to = 1 + static_cast<int>(random.below(3));
    return settings;
}

model::Call random_call(Random& random) {
    if (chance(random, 6)) return model::Safety{};
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

/// Mostly what is due, sometimes anything.
Command random_command(const MatchState& match, Random& random) {
    model::TurnNumber turn = match.turn;
    if (chance(random, 20)) ++turn.value;
    const bool in_hand = match.layout.find(model::kCueBall)->place == model::Place::InHand;
    const int kind = chance(random, 5)                ? static_cast<int>(random.below(4))
                     : match.stage == Stage::Choosing ? 2
                     : in_hand                        ? 0
                                                      : 1;
    switch (kind) {
        case 0:
            return PlaceCueBall{{random.uniform(-1.3, 1.3), random.uniform(-0.7, 0.7)}};
        case 1:
            return TakeShot{turn, random_shot(random), random_call(random)};
        case 2:
            return Choose{turn, static_cast<rules::Choice>(random.below(5))};
        default:
            return Timeout{turn};
    }
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
        const Command command = random_command(match, random);
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
        EXPECT_EQ(folded_again(before, seat, command, step->outcome), step->next);
        match = std::move(step).value().next;
        expect_sound(match);
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

}  // namespace
}  // namespace billiards::match
