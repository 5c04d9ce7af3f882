// Takes a match and its seat to act; gives a command that a simple, honest player would send.
#pragma once

#include "common/base/random.h"
#include "common/match/match_state.h"

namespace billiards::bot {

/// A legal command for state.to_act: where the cue ball is in hand and not yet set down, a
/// placement; where a choice is due, a choice; else a shot with its call. It looks at straight
/// pots only, tries the best of them in the engine, and plays a safety where it sees none.
/// Deterministic for the same state and random. The match must not be over.
match::Command choose(const match::MatchState& state, base::Random& random);

}  // namespace billiards::bot
