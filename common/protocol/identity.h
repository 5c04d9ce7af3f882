// Gives how tables, players and their secrets are named between a client and a server.
#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace billiards::protocol {

// The order of every enum and variant here is part of the wire format; only append.

struct TableId {
    std::uint32_t value = 0;
    friend auto operator<=>(TableId, TableId) = default;
};

/// 256 secret bits that let a player come back after a lost connection.
using ResumeToken = std::array<std::uint8_t, 32>;

/// 128 secret bits that open a private table, or a passcode's table, to whoever holds them.
using InviteSecret = std::array<std::uint8_t, 16>;

enum class Role : std::uint8_t { Player, Spectator, BothSeats };

}  // namespace billiards::protocol
