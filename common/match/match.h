// Takes a match and a command; gives the next match, or a refusal and nothing changed. Live play,
// replay, resume and late joining are this one fold.
#pragma once

#include "common/match/match_state.h"
#include "common/match/refusal.h"
#include "common/physics/parameters.h"
#include "common/timeline/shot_record.h"

#include <cstdint>
#include <optional>

namespace billiards::match {

/// What a command led to besides the next state: what cannot be folded again without solving.
struct Outcome {
    std::optional<timeline::ShotRecord> record;  ///< TakeShot only.
    std::optional<rules::Verdict> verdict;       ///< TakeShot and Timeout.

    friend bool operator==(const Outcome&, const Outcome&) = default;
};

struct Step {
    MatchState next;
    Outcome outcome;
};

/// The engine's parameters for a preset.
const physics::Parameters& parameters_of(PhysicsPreset preset);

/// A fresh match, ready for the first break; the seed decides who breaks and every rack. A rematch
/// is no more than this: the same settings and another seed.
Result<MatchState> start(const Settings& settings, std::uint64_t seed);

/// Pure. Checks the command, solves and judges a shot, and folds it in.
Result<Step> apply(const MatchState& state, model::Seat seat, const Command& command);

/// The fold alone, for what was applied before: takes the journalled outcome instead of solving
/// again, so that a changed engine still plays old matches. Of the record only `final_layout` is
/// read. Refuses what apply would refuse but for the physics.
Result<MatchState> refold(const MatchState& state, model::Seat seat, const Command& command,
                          const std::optional<model::Layout>& final_layout,
                          const std::optional<rules::Verdict>& verdict);

}  // namespace billiards::match
