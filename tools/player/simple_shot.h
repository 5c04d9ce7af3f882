// Takes a match; gives a legal command at almost no cost: for load, where what a player decides
// matters less than what it costs to decide.
#pragma once

#include "common/base/random.h"
#include "common/match/match_state.h"

namespace billiards::tools {

/// Aims at the legal ball with the straightest way to a pocket, and calls that; looks at no
/// obstacle and asks no engine. Where the cue ball is in hand, the usual place; where a choice is
/// due, the first. The match must not be over.
match::Command simple_shot(const match::MatchState& state, base::Random& random);

}  // namespace billiards::tools
