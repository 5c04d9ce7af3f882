// Takes the addresses that connections come from; gives which are let in.
#pragma once

#include "server/session/address_key.h"

#include <asio/ip/address.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace billiards::server {

/// So many connections an address at once, and so many new ones a window. An IPv6 address counts
/// with its whole /64, which is what one household has. Loopback is not limited.
class AddressLimits {
  public:
    using Clock = std::chrono::steady_clock;
    struct Limits {
        int connections = 64;
        int new_connections = 20;  ///< In one window.
        Clock::duration window = std::chrono::seconds(10);
        std::size_t addresses = 100'000;  ///< Remembered at once; beyond it no new one is let in.
    };

    explicit AddressLimits(const Limits& limits) : limits_(limits) {}

    static AddressKey key_of(const asio::ip::address& address);
    /// Counts the connection and gives true, or gives false and counts nothing.
    bool admit(AddressKey key, Clock::time_point now);
    /// An admitted connection is gone.
    void release(AddressKey key);
    /// Lets go of addresses without a connection whose window is over.
    void forget_old(Clock::time_point now);

  private:
    struct Count {
        int connections = 0;
        int new_connections = 0;
        Clock::time_point window_start;
    };

    Limits limits_;
    std::unordered_map<std::uint64_t, Count> counts_;
};

}  // namespace billiards::server
