// Takes settings and a seed; gives a whole match by a chooser at random.
#include "tests/common/match/random_play.h"

#include "common/base/elementary.h"
#include "common/bot/candidates.h"
#include "common/match/legality.h"
#include "common/match/placement.h"
#include "common/model/table_spec.h"
#include "common/rules/ruleset.h"
#include "tests/common/match/soundness.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace billiards::match {

namespace {

using base::Random;
using base::Vec2;

bool chance(Random& random, std::uint64_t in) {
    return random.below(in) == 0;
}

template <class T>
const T& any_of(const std::vector<T>& values, Random& random) {
    return values[random.below(values.size())];
}

const model::TableSpec& table_of(const MatchState& match) {
    return model::table_of(match.settings.table);
}

Vec2 random_place(const MatchState& match, Random& random) {
    const Vec2 half_m = table_of(match).half_playing_m;
    for (int i = 0; i < 8; ++i) {
        const Vec2 place_m{random.uniform(-half_m.x, half_m.x),
                           random.uniform(-half_m.y, half_m.y)};
        if (check(match, match.to_act, PlaceCueBall{place_m})) return place_m;
    }
    return default_placement(table_of(match), match.layout, match.rack.in_hand);
}

/// What is said where no pot is aimed at: anything that is allowed.
model::Call random_call(const MatchState& match, Random& random) {
    const rules::Ruleset& rules = rules::ruleset_of(match.settings.game);
    for (const model::Call& call : {model::Call(model::PushOut{}), model::Call(model::Safety{})}) {
        const bool allowed = rules.is_call_allowed(match.rack, match.settings.options, call);
        if (allowed && chance(random, 3)) return call;
    }
    return model::NoCall{};
}

double towards(Vec2 from_m, Vec2 to_m) {
    return base::arc_tangent(to_m.y - from_m.y, to_m.x - from_m.x);
}

TakeShot at_some_legal_ball(const MatchState& match, Vec2 cue_ball_m, model::BallSet targets,
                            Random& random) {
    std::vector<Vec2> places_m;
    targets.for_each(
        [&](model::BallId ball) { places_m.push_back(match.layout.find(ball)->position_m); });
    const double angle_rad = towards(cue_ball_m, any_of(places_m, random));
    return {
        match.turn,
        {.angle_rad = angle_rad + random.uniform(-0.03, 0.03), .power = random.uniform(0.1, 1.0)},
        random_call(match, random)};
}

TakeShot random_shot(const MatchState& match, Random& random) {
    const Vec2 cue_ball_m = match.layout.find(model::kCueBall)->position_m;
    const rules::Ruleset& rules = rules::ruleset_of(match.settings.game);
    const model::BallSet targets = rules.legal_first_balls(match.rack);
    std::vector<bot::Pot> pots = bot::pots_from(table_of(match), match.layout, targets, cue_ball_m);
    const bool breaks = match.rack.phase == rules::Phase::Break;
    if (pots.empty() || breaks || chance(random, 8)) {
        return at_some_legal_ball(match, cue_ball_m, targets, random);
    }
    pots.resize(std::min<std::size_t>(pots.size(), 3));
    const bot::Pot& pot = any_of(pots, random);
    TakeShot take{match.turn, {}, model::CalledBall{pot.ball, pot.pocket}};
    take.shot.angle_rad = bot::aim_rad(cue_ball_m, pot) + random.uniform(-0.004, 0.004);
    take.shot.power = random.uniform(0.1, 0.5);
    if (chance(random, 4)) take.shot.tip_up = random.uniform(-0.4, 0.4);
    const bool allowed = rules.is_call_allowed(match.rack, match.settings.options, take.call);
    if (!allowed) take.call = random_call(match, random);
    return take;
}

}  // namespace

Settings short_settings(rules::Game game, Random& random) {
    Settings settings;
    settings.game = game;
    settings.race_to = 1;
    settings.options.call = !chance(random, 3);
    settings.options.nine_on_foot_spot = chance(random, 2);
    settings.options.ten_wins_any_time = chance(random, 2);
    settings.options.target_points = 1 + static_cast<int>(random.below(30));
    settings.table = static_cast<model::TableSize>(random.below(3));
    settings.physics = chance(random, 4) ? PhysicsPreset::Classic : PhysicsPreset::Realistic;
    settings.break_order = static_cast<BreakOrder>(random.below(3));
    return settings;
}

Command random_legal_command(const MatchState& match, Random& random) {
    if (match.stage == Stage::Choosing) {
        return Choose{match.turn, any_of(match.pending->verdict.choices, random)};
    }
    if (match.rack.on_table.empty()) return Concede{};  // Practice is done.
    if (!match.layout.on_table(model::kCueBall)) return PlaceCueBall{random_place(match, random)};
    const Command spot = SpotNearest{match.turn};
    if (chance(random, 2) && check(match, match.to_act, spot)) return spot;
    if (match.settings.game != rules::Game::Practice && chance(random, 50)) {
        return Timeout{match.turn};
    }
    return random_shot(match, random);
}

PlayedMatch play_match(rules::Game game, std::uint64_t seed) {
    Random random(seed);
    auto begun = start(short_settings(game, random), seed);
    if (!begun) return {.shots = 0, .fault = begun.error().detail};
    MatchState match = std::move(begun).value();
    while (match.stage != Stage::Over) {
        if (match.shots_played >= kMostShots) return {match.shots_played, "it does not end"};
        const Command command = random_legal_command(match, random);
        auto step = apply(match, match.to_act, command);
        if (!step) return {match.shots_played, "refused: " + step.error().detail};
        if (auto fault = first_fault(match, match.to_act, command, *step)) {
            return {match.shots_played, std::move(fault)};
        }
        match = std::move(step).value().next;
    }
    const bool decided = match.winner.has_value() || game == rules::Game::Practice;
    return {match.shots_played, decided ? std::nullopt : std::optional<std::string>("undecided")};
}

}  // namespace billiards::match
