// Gives what the network counts.
#pragma once

#include <cstddef>
#include <cstdint>

namespace billiards::server {

/// Since the start, but for the connections, which are those of now.
struct NetStats {
    std::size_t connections = 0;
    std::uint64_t accepted = 0;
    std::uint64_t turned_away = 0;  ///< Over the limit of connections, of all or of an address.
    std::uint64_t frames_in = 0;
    std::uint64_t frames_out = 0;
    std::uint64_t bytes_in = 0;
    std::uint64_t bytes_out = 0;
    std::uint64_t malformed = 0;  ///< Preambles, frames and messages that were none.
    std::uint64_t timed_out = 0;
    std::uint64_t too_slow = 0;  ///< Receivers cut off with a full queue.
};

}  // namespace billiards::server
