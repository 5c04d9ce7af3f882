// Takes a match and a shot; gives its worth: what the ruling says, and how the balls then lie.
#include "common/bot/evaluate.h"

#include "common/bot/candidates.h"
#include "common/model/table_spec.h"
#include "common/rules/ruleset.h"

#include <utility>

namespace billiards::bot {

namespace {

constexpr double kRack = 1000.0;
constexpr double kTurn = 100.0;
/// The margin at which a pot is as likely to be made as missed by a fair player.
constexpr double kFairMargin_rad = 0.01;

double worth_of(const match::Step& step, model::Seat shooter) {
    const rules::Verdict& verdict = *step.outcome.verdict;
    if (verdict.winner) return *verdict.winner == shooter ? kRack : -kRack;
    const double position = kTurn * outlook(step.next);
    if (verdict.next_player == shooter) return kTurn + position;
    return verdict.fouls.empty() ? -position : -2 * kTurn - position;
}

}  // namespace

double outlook(const match::MatchState& state) {
    const model::PlacedBall* cue_ball = state.layout.find(model::kCueBall);
    if (cue_ball->place != model::Place::OnTable) return 1.0;  // In hand there is always a pot.
    const rules::Ruleset& rules = rules::ruleset_of(state.settings.game);
    const std::vector<Pot> pots =
        pots_from(model::table_of(state.settings.table), state.layout,
                  rules.legal_first_balls(state.rack), cue_ball->position_m);
    if (pots.empty()) return 0.0;
    return pots.front().margin_rad / (pots.front().margin_rad + kFairMargin_rad);
}

std::optional<Trial> try_shot(const match::MatchState& state, const model::Shot& shot,
                              const model::Call& call) {
    const match::TakeShot command{state.turn, shot, call};
    auto step = match::apply(state, state.to_act, command);
    if (!step) return std::nullopt;
    const double worth = worth_of(*step, state.to_act);
    return Trial{command, std::move(step).value(), worth};
}

}  // namespace billiards::bot
