// Takes a match; gives how long its player may take. Whoever has a clock counts it down and says
// Timeout; here is none.
#pragma once

#include "common/match/match_state.h"

#include <optional>

namespace billiards::match {

/// A player is warned when this much of an allowance is left.
inline constexpr double kWarning_s = 10.0;

/// For the turn that is, from when it opens, its extension included. None: it may last for ever.
std::optional<double> allowance_s(const MatchState& match);

/// How long after the turn opens its player is warned; none where no clock runs, or where no more
/// than kWarning_s is allowed from the start.
std::optional<double> warning_after_s(const MatchState& match);

}  // namespace billiards::match
