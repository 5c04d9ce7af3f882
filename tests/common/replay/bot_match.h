// Gives matches that two bots have played, as replays.
#pragma once

#include "common/match/match_state.h"
#include "common/replay/replay.h"

#include <cstddef>
#include <cstdint>

namespace billiards::replay {

/// To its end, or until it has this many entries. The bots miss now and then.
Replay bot_match(const match::Settings& settings, std::uint64_t seed,
                 std::size_t most_entries = 10'000);

inline match::Settings race_to(int racks) {
    match::Settings settings;
    settings.race_to = racks;
    return settings;
}

}  // namespace billiards::replay
