// Takes a match, a command and an outcome read from a journal; gives whether they belong together.
#pragma once

#include "common/base/result.h"
#include "common/match/match_state.h"
#include "common/match/refusal.h"
#include "common/model/layout.h"
#include "common/rules/verdict.h"

#include <optional>

namespace billiards::match {

/// Whether the fold can take this outcome and keep what every match keeps: each ball once, a cue
/// ball to play on with, only spotted what is down. Whether it is the right outcome is not asked.
/// The command is legal.
Result<base::Done> check_outcome(const MatchState& state, const Command& command,
                                 const std::optional<model::Layout>& final_layout,
                                 const std::optional<rules::Verdict>& verdict);

}  // namespace billiards::match
