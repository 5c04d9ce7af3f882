// Takes a match and a shot; gives what that shot would come to, tried in the engine.
#pragma once

#include "common/match/match.h"
#include "common/match/match_state.h"
#include "common/model/shot.h"

#include <optional>

namespace billiards::bot {

struct Trial {
    match::TakeShot command;
    match::Step step;
    /// For the shooter: 1000 or -1000 for the rack, 100 to 200 for keeping the turn, -100 to 0 for
    /// passing it, -300 to -200 for a foul.
    double worth = 0.0;
};

/// None where the match refuses the shot.
std::optional<Trial> try_shot(const match::MatchState& state, const model::Shot& shot,
                              const model::Call& call);

/// How good the table looks to whoever shoots next, in [0, 1]: 0 sees no straight pot.
double outlook(const match::MatchState& state);

}  // namespace billiards::bot
