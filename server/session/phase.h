// Takes a phase of a session and a message from its client; says whether the one has a place in
// the other. The table stands in phase.cpp.
#pragma once

#include "common/protocol/messages.h"

#include <cstdint>
#include <string_view>

namespace billiards::server {

enum class Phase : std::uint8_t {
    Greeting,  ///< Connected; only Hello.
    Entering,  ///< Hello was heard, and is being made durable; Welcome ends it.
    Lobby,     ///< Known, at no table.
    Watching,  ///< A spectator.
    Seated,    ///< On one seat, or both.
};

bool is_legal(Phase phase, const protocol::ClientMessageBody& message);

/// For the details of refusals and for logs.
std::string_view name_of(Phase phase);
std::string_view name_of(const protocol::ClientMessageBody& message);

}  // namespace billiards::server
