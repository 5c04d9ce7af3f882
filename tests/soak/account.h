// Gives what one client was told of a match, and what a server's journal has of it, in one form.
#pragma once

#include "common/match/match_state.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <map>
#include <optional>

namespace billiards::soak {

/// A shot as everybody must agree on it.
struct Shot {
    std::uint64_t shot_id = 0;
    std::uint64_t record_hash = 0;
    match::MatchState after;  ///< Without its seed.
    friend bool operator==(const Shot&, const Shot&) = default;
};

struct Account {
    std::map<int, Shot> shots;  ///< By their number in the match, from 1.
    int known = 0;              ///< Shots that it was told of, or knows to have missed.
    std::optional<protocol::server::MatchOver> over;
};

}  // namespace billiards::soak
