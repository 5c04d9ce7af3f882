// Takes a match; gives what is wrong with it: what every match keeps, whatever was done in it.
#pragma once

#include "common/match/match.h"

#include <optional>
#include <string>

namespace billiards::match {

/// Ball counts, overlaps, who acts, phases, scores and race. None: it is sound.
std::optional<std::string> first_fault(const MatchState& match);

/// Whether the step leaves what it was taken from alone, is told again by its journal entry alone,
/// and leads to a sound match.
std::optional<std::string> first_fault(const MatchState& before, model::Seat seat,
                                       const Command& command, const Step& step);

}  // namespace billiards::match
