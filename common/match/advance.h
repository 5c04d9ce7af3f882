// Takes a match, a command that was found legal and what it led to; gives the next match. The one
// fold behind live play and replay: nothing here solves, judges or refuses.
#pragma once

#include "common/match/match_state.h"
#include "common/model/layout.h"
#include "common/model/seat.h"
#include "common/rules/verdict.h"

namespace billiards::match {

/// What the world adds to a command: a shot's end and its ruling, or a timeout's ruling. Lent for
/// the call; null where the command has none.
struct Consequence {
    const model::Layout* final_layout = nullptr;
    const rules::Verdict* verdict = nullptr;
};

/// The first rack, ready to be broken. The settings are valid.
MatchState first_rack(const Settings& settings, std::uint64_t seed);

/// `command` is legal for `seat`; a TakeShot comes with both parts of the consequence, a Timeout
/// while shooting with a verdict.
MatchState advance(const MatchState& state, model::Seat seat, const Command& command,
                   const Consequence& consequence);

}  // namespace billiards::match
