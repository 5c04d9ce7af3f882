// Gives what a table needs of the world around it: where frames and writes go, and what counts.
#pragma once

#include "server/session/limits.h"
#include "server/session/token.h"
#include "server/store/committer.h"
#include "server/store/match_store.h"
#include "server/table/outbox.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>

namespace billiards::server {

struct LobbyStats {
    std::size_t sessions = 0;
    std::size_t tables = 0;
    std::size_t matches_running = 0;
    std::uint64_t shots = 0;
    std::uint64_t refusals = 0;
    std::uint64_t unsolvable = 0;  ///< Of those, shots in which too much happens.
    bool storage_failing = false;  ///< The last commit failed: not ready.
};

/// Outlives every table, and every answer that the committer still owes.
struct Surroundings {
    LobbyLimits limits;
    Outbox& outbox;
    Committer& committer;
    RandomBytes random;
    /// A disk has answered and the table with this id moved on: its deadline and row may differ.
    std::function<void(protocol::TableId)> moved;
    /// This session's shot was refused as unsolvable.
    std::function<void(SessionId)> unsolvable;
    std::uint64_t last_match = 0;           ///< The highest MatchId given so far.
    std::set<protocol::TableId> unsaved{};  ///< Tables whose last SaveTable failed.
    LobbyStats stats{};  ///< The counters; sessions, tables and matches are counted late.
};

}  // namespace billiards::server
