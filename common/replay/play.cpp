// Takes a replay; gives the match step by step, as it was played, whatever the engine does today.
#include "common/replay/play.h"

#include "common/match/match.h"

#include <fmt/format.h>
#include <utility>

namespace billiards::replay {

Result<match::MatchState> play(const Replay& replay, const Visit& visit) {
    auto start = match::start(replay.header.settings, replay.header.seed);
    if (!start) return Fault{FaultCode::Invalid, "settings: " + start.error().detail};
    match::MatchState state = std::move(start).value();
    for (std::size_t index = 0; index < replay.entries.size(); ++index) {
        const protocol::JournalEntry& entry = replay.entries[index];
        if (std::holds_alternative<match::TakeShot>(entry.command) && !entry.record) {
            return Fault{FaultCode::Invalid,
                         fmt::format("entry {}: a shot without its record", index + 1)};
        }
        auto next =
            match::refold(state, entry.seat, entry.command, entry.final_layout, entry.verdict);
        if (!next) {
            return Fault{FaultCode::Invalid,
                         fmt::format("entry {}: {}", index + 1, next.error().detail)};
        }
        visit({.index = index, .before = state, .entry = entry, .after = *next});
        state = std::move(next).value();
    }
    return state;
}

}  // namespace billiards::replay
