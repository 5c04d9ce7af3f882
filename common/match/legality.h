// Takes a match, a seat and a command; gives whether that seat may do that now.
#pragma once

#include "common/base/result.h"
#include "common/match/match_state.h"
#include "common/match/refusal.h"
#include "common/model/seat.h"

namespace billiards::match {

/// Everything that can be refused without solving a shot.
Result<base::Done> check(const MatchState& state, model::Seat seat, const Command& command);

}  // namespace billiards::match
