// Takes a match and a command; gives the next match: checked, solved, judged, folded.
#include "common/match/match.h"

#include "common/base/check.h"
#include "common/match/advance.h"
#include "common/match/legality.h"
#include "common/match/outcome_check.h"
#include "common/model/table_spec.h"
#include "common/physics/simulate.h"
#include "common/rules/facts.h"
#include "common/rules/ruleset.h"

#include <utility>

namespace billiards::match {

namespace {

Result<Outcome> play(const MatchState& state, const TakeShot& command) {
    const Settings& settings = state.settings;
    auto solved =
        physics::simulate_shot(model::table_of(settings.table), parameters_of(settings.physics),
                               state.layout, command.shot);
    if (!solved) return Refusal{RefusalCode::Unsolvable, solved.error().detail};
    const rules::Facts facts = rules::facts_of(solved->events);
    const rules::Ruleset& rules = rules::ruleset_of(settings.game);
    rules::Verdict verdict = rules.judge(state.rack, settings.options, command.call, facts);
    return Outcome{std::move(solved).value(), std::move(verdict)};
}

/// What a legal command leads to besides the next state.
Result<Outcome> outcome_of(const MatchState& state, const Command& command) {
    if (const auto* shot = std::get_if<TakeShot>(&command)) return play(state, *shot);
    Outcome outcome;
    if (std::holds_alternative<Timeout>(command) && state.stage == Stage::Shooting) {
        outcome.verdict = rules::ruleset_of(state.settings.game).judge_timeout(state.rack);
    }
    return outcome;
}

}  // namespace

const physics::Parameters& parameters_of(PhysicsPreset preset) {
    static const physics::Parameters realistic = physics::realistic_parameters();
    static const physics::Parameters classic = physics::classic_parameters();
    switch (preset) {
        case PhysicsPreset::Realistic:
            return realistic;
        case PhysicsPreset::Classic:
            return classic;
    }
    CHECK(false);
}

Result<MatchState> start(const Settings& settings, std::uint64_t seed) {
    if (const auto checked = check(settings); !checked) return checked.error();
    return first_rack(settings, seed);
}

Result<Step> apply(const MatchState& state, model::Seat seat, const Command& command) {
    if (const auto checked = check(state, seat, command); !checked) return checked.error();
    auto outcome = outcome_of(state, command);
    if (!outcome) return std::move(outcome).error();
    const auto& [record, verdict] = *outcome;
    const Consequence consequence{record ? &record->final_layout : nullptr,
                                  verdict ? &*verdict : nullptr};
    MatchState next = advance(state, seat, command, consequence);
    return Step{std::move(next), std::move(outcome).value()};
}

Result<MatchState> refold(const MatchState& state, model::Seat seat, const Command& command,
                          const std::optional<model::Layout>& final_layout,
                          const std::optional<rules::Verdict>& verdict) {
    if (const auto checked = check(state, seat, command); !checked) return checked.error();
    const auto fits = check_outcome(state, command, final_layout, verdict);
    if (!fits) return fits.error();
    const Consequence consequence{final_layout ? &*final_layout : nullptr,
                                  verdict ? &*verdict : nullptr};
    return advance(state, seat, command, consequence);
}

}  // namespace billiards::match
