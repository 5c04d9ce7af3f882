// Takes a replay; gives the match step by step, as it was played, whatever the engine does today.
#pragma once

#include "common/replay/replay.h"

#include <cstddef>
#include <functional>

namespace billiards::replay {

/// One entry between the match before it and the match after it; valid during the visit.
struct Moment {
    std::size_t index = 0;  ///< Of the entry.
    const match::MatchState& before;
    const protocol::JournalEntry& entry;
    const match::MatchState& after;
};

using Visit = std::function<void(const Moment&)>;

/// The match as it stood at the end. No shot is solved; each has a record to be shown. Where an
/// entry does not follow from those before it, all before have been visited, and the fault names
/// it.
Result<match::MatchState> play(const Replay& replay, const Visit& visit);

}  // namespace billiards::replay
