// Gives every limit of the network that is the server's own: its name and its default.
#pragma once

#include "common/protocol/limits.h"
#include "server/net/address_limits.h"

#include <chrono>
#include <cstddef>

namespace billiards::server {

struct NetLimits {
    using Milliseconds = std::chrono::milliseconds;

    /// Of all addresses together; fewer where the system gives fewer descriptors.
    std::size_t connections = 20'000;
    std::size_t descriptor_reserve = 64;  ///< Kept from connections, for files and status pages.
    AddressLimits::Limits address;

    /// From the connection to the end of the first message. Idle sessions are the game's affair.
    Milliseconds greeting_timeout = protocol::kGreetingTimeout;
    Milliseconds frame_timeout = std::chrono::seconds(5);    ///< From its header to its last byte.
    Milliseconds closing_timeout = std::chrono::seconds(2);  ///< To take what still waits.
    /// Of what is said by a connection that closes; read, so that nothing cuts off our last words.
    std::size_t dropped_bytes = 64 * 1024;
    /// Connections without room that close so, in the reserve; beyond it they may not hear why.
    std::size_t turned_away_at_once = 16;
    /// How often timeouts are looked at: each may be late by this much.
    Milliseconds tick = std::chrono::seconds(1);
    Milliseconds pause_when_out_of_sockets = std::chrono::seconds(1);

    std::size_t queued_bytes = 4 * 1024 * 1024;  ///< A receiver; beyond it the connection is cut.
    /// For a spectator; beyond it what can be shed is, until it has caught up. One frame may be
    /// more.
    std::size_t sheddable_bytes = 256 * 1024;
    /// What the system holds for one receiver beyond that (it takes twice as much for itself): so
    /// much of what a slow one sees is old, at most.
    int send_buffer_bytes = 256 * 1024;
    /// A receiver that takes not a byte of what it is sent for so long is cut.
    Milliseconds stalled_timeout = std::chrono::seconds(60);
    /// Said by one connection and not yet dealt with; beyond it nothing more is read from it.
    int messages_in_flight = 32;
    int messages_per_tick = 100;  ///< Read from one connection; the rest waits for the next tick.
};

}  // namespace billiards::server
