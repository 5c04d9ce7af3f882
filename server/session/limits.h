// Gives every limit of the game side of the server: its name and its default.
#pragma once

#include "common/base/time.h"
#include "common/protocol/limits.h"

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace billiards::server {

/// Counts and rates are at least 1.
struct LobbyLimits {
    int max_tables = 4000;
    std::size_t tables_per_address = 8;  ///< Opened from there since the start, and standing.
    int max_spectators_per_table = 20'000;
    int max_players = 1'000'000;  ///< Guests known at once.

    int lobby_requests_per_10s = 30;  ///< A session's lists, openings, joins and leaves together.
    int questions_waiting = 1;        ///< A session's, of what has been played.
    int chat_per_10s = 8;             ///< A session.
    int table_chat_per_10s = 100;     ///< The players at one table, or its spectators.
    int placements_per_10s = 20;      ///< Balls set down at one table.
    int practice_shots_per_s = 5;  ///< At one table, and steps back; a match of two waits instead.
    int aim_per_s_to_players = 10;
    int aim_per_s_to_spectators = 4;
    int unsolvable_per_min = 6;  ///< A session's shots that nobody can solve: each costs its time.
    int illegal_messages = 20;   ///< Refused for their phase or form, before the session is closed.

    /// Of one table, while one step is on its way to the disk.
    std::size_t queued_commands = 8;

    /// Of one match's journal: then it can only be ended. No quota drops what is being played.
    std::uint64_t entries_per_match = 20'000;

    int wrong_secrets_per_min = 5;       ///< Invites and passcodes tried at one table.
    std::size_t invites_per_table = 32;  ///< That stand at once.
    std::size_t kicked_per_table = 100;  ///< Remembered; the oldest is forgotten first.
    base::Duration invite_kept = std::chrono::hours(24);  ///< Counts anew after a restart.

    /// A shot with a longer record is refused as unsolvable: it would not fit into a frame.
    std::size_t record_bytes = protocol::kMaxRecordBytes;

    /// A table's newest events, for those who lost their link: both limits hold.
    std::size_t kept_events = 256;
    std::size_t kept_event_bytes = 256 * 1024;

    /// What waits for the delayed spectators of one table: messages, and about the bytes they take.
    std::size_t delayed_events = 4096;
    std::size_t delayed_bytes = 8 * 1024 * 1024;

    /// How long a player may be away in one match while the opponent is there, who may then claim
    /// it; and how long an absent player keeps the seat between two matches.
    base::Duration absence_grace = std::chrono::seconds(60);
    /// How long a table stands at which no player is connected; a match on it ends with it.
    base::Duration empty_table_kept = std::chrono::minutes(10);
    /// A shot that is on its way when the clock reaches zero still counts.
    base::Duration shot_grace = std::chrono::milliseconds(250);
    /// How old the rows of a table list may be.
    base::Duration table_list_kept = std::chrono::milliseconds(100);
    /// How often whoever follows the list is told what changed in it, at most.
    base::Duration table_changes_every = std::chrono::milliseconds(500);
    /// How often the disk is tried while it fails, so that readiness comes back by itself.
    base::Duration storage_probe_every = std::chrono::seconds(5);
    /// How often spectators coming and going are announced, at most.
    base::Duration spectator_count_every = std::chrono::seconds(1);
};

}  // namespace billiards::server
