// Takes a match; aims by the ghost ball: where the cue ball must be when it sends a ball straight
// to a pocket.
#include "tools/player/simple_shot.h"

#include "common/base/elementary.h"
#include "common/match/placement.h"
#include "common/model/ball.h"
#include "common/model/table_spec.h"
#include "common/rules/ruleset.h"

#include <cstdint>
#include <optional>

namespace billiards::tools {

namespace {

struct Aim {
    model::CalledBall called;
    base::Vec2 direction{};
    double straightness = -2.0;  ///< Cosine of the cut; below 0 the ball would go backwards.
};

Aim aim_at(const model::TableSpec& table, base::Vec2 cue_m, const model::PlacedBall& target,
           std::uint8_t pocket) {
    const base::Vec2 way = glm::normalize(table.pockets[pocket].center_m - target.position_m);
    const base::Vec2 ghost_m = target.position_m - way * (2.0 * model::BallSpec{}.radius_m);
    const base::Vec2 direction = ghost_m - cue_m;
    return {.called = {target.ball, model::PocketId{pocket}},
            .direction = direction,
            .straightness = glm::dot(glm::normalize(target.position_m - cue_m), way)};
}

Aim straightest(const match::MatchState& state, const model::TableSpec& table, base::Vec2 cue_m) {
    Aim best;
    rules::ruleset_of(state.settings.game)
        .legal_first_balls(state.rack)
        .for_each([&](model::BallId ball) {
            const model::PlacedBall* target = state.layout.find(ball);
            if (target == nullptr || target->place != model::Place::OnTable) return;
            for (std::uint8_t pocket = 0; pocket < model::kPockets; ++pocket) {
                const Aim aim = aim_at(table, cue_m, *target, pocket);
                if (aim.straightness > best.straightness) best = aim;
            }
        });
    return best;
}

match::TakeShot shot_from(const match::MatchState& state, const model::TableSpec& table,
                          base::Vec2 cue_m, base::Random& random) {
    const bool is_break = state.rack.phase == rules::Phase::Break;
    const Aim aim = straightest(state, table, cue_m);
    const base::Vec2 direction = is_break ? model::foot_spot(table) - cue_m : aim.direction;
    match::TakeShot take{.turn = state.turn, .shot = {}, .call = aim.called};
    take.shot.angle_rad =
        base::arc_tangent(direction.y, direction.x) + base::radians(random.uniform(-0.5, 0.5));
    take.shot.power = is_break ? random.uniform(0.8, 1.0) : random.uniform(0.1, 0.4);
    const rules::Ruleset& ruleset = rules::ruleset_of(state.settings.game);
    if (!ruleset.is_call_allowed(state.rack, state.settings.options, take.call)) {
        take.call = model::NoCall{};
    }
    return take;
}

}  // namespace

match::Command simple_shot(const match::MatchState& state, base::Random& random) {
    if (state.stage == match::Stage::Choosing) {
        return match::Choose{.turn = state.turn, .choice = state.pending->verdict.choices.front()};
    }
    if (state.rack.on_table.empty()) return match::Concede{};  // Practice is done.
    const model::TableSpec& table = model::table_of(state.settings.table);
    const model::PlacedBall* cue_ball = state.layout.find(model::kCueBall);
    if (cue_ball == nullptr || cue_ball->place != model::Place::OnTable) {
        return match::PlaceCueBall{
            match::default_placement(table, state.layout, state.rack.in_hand)};
    }
    return shot_from(state, table, cue_ball->position_m, random);
}

}  // namespace billiards::tools
