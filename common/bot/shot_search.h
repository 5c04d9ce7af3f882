// Takes a match whose seat to act must shoot; gives the best of a bounded number of shots tried.
#pragma once

#include "common/base/random.h"
#include "common/match/match_state.h"

namespace billiards::bot {

/// The most shots that one choice tries in the engine.
inline constexpr int kMaxTrials = 128;

/// The cue ball lies on the table.
match::TakeShot best_shot(const match::MatchState& state);

/// Hard and full into the rack. Not tried beforehand: nobody can see through a break.
match::TakeShot break_shot(const match::MatchState& state, base::Random& random);

}  // namespace billiards::bot
