// Takes a match and a command; gives the next match, or a refusal and nothing changed. Live play,
// replay, resume and late joining are this one fold.
#pragma once

#include "common/base/result.h"
#include "common/match/match_state.h"
#include "common/physics/parameters.h"
#include "common/timeline/shot_record.h"

#include <cstdint>
#include <optional>
#include <string>

namespace billiards::match {

/// The order is part of the wire format; only append.
enum class RefusalCode : std::uint8_t {
    BadSettings,
    MatchOver,
    NotYourTurn,
    StaleTurn,         ///< The turn number is not the current one.
    WrongStage,        ///< A shot while a choice is due, or the other way round.
    NotInHand,         ///< The cue ball may not be placed now.
    CueBallNotPlaced,  ///< It is in hand, and was not set down.
    BadPlacement,      ///< Outside the zone, over a pocket or cushion, or on another ball.
    BadShot,           ///< A number that makes no sense; detail names it.
    BadCall,           ///< This ball, pocket or call is not allowed now.
    BadChoice,         ///< Not one of those offered.
    Unsolvable,        ///< The engine gave up on this shot; nothing was played.
    BadOutcome,        ///< refold only: the journalled outcome does not belong to this command.
};

struct Refusal {
    RefusalCode code = RefusalCode::NotYourTurn;
    std::string detail;

    friend bool operator==(const Refusal&, const Refusal&) = default;
};

template <class T>
using Result = base::Result<T, Refusal>;

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

/// A fresh match, ready for the first break; the seed decides who breaks and every rack.
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
