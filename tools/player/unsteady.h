// Takes a way of choosing; gives the same with a hand that is not quite steady, so that a match
// between two programs has misses, fouls and safeties in it, as one between people has.
#pragma once

#include "common/base/random.h"
#include "common/match/match_state.h"

#include <functional>

namespace billiards::tools {

using Choose = std::function<match::Command(const match::MatchState&, base::Random&)>;

/// Every shot goes astray by up to error_rad to either side, uniformly; 0: none does.
Choose unsteady(Choose choose, double error_rad);

}  // namespace billiards::tools
