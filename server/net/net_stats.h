// Gives what the network counts.
#pragma once

#include <cstddef>
#include <cstdint>

namespace billiards::server {

/// Since the start, but for the connections and the bytes in queues, which are those of now.
struct NetStats {
    std::size_t connections = 0;
    std::uint64_t accepted = 0;
    std::uint64_t turned_away = 0;      ///< Over the limit of connections, of all or of an address.
    std::uint64_t accept_failures = 0;  ///< After each, nobody is let in for a moment.
    std::uint64_t frames_in = 0;
    std::uint64_t frames_out = 0;
    std::uint64_t bytes_in = 0;
    std::uint64_t bytes_out = 0;
    std::uint64_t malformed = 0;  ///< Preambles, frames and messages that were none.
    std::uint64_t timed_out = 0;
    std::uint64_t too_slow = 0;     ///< Receivers cut off with a full queue.
    std::uint64_t stalled = 0;      ///< Receivers cut off because they took nothing any more.
    std::uint64_t shed = 0;         ///< Frames that spectators did not get, being behind.
    std::uint64_t fell_behind = 0;  ///< How often one was brought up to date in place of those.
    std::size_t queued_bytes = 0;   ///< Frames that wait or are being written now, of all together.
};

}  // namespace billiards::server
