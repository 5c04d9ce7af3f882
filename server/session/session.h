// Gives one connection as the game sees it: how far it has come, as whom, and what it may spend.
#pragma once

#include "common/base/time.h"
#include "common/protocol/limits.h"
#include "common/protocol/messages.h"
#include "server/session/address_key.h"
#include "server/session/limits.h"
#include "server/session/phase.h"
#include "server/session/rate_limit.h"
#include "server/store/match_store.h"
#include "server/table/outbox.h"

#include <chrono>
#include <optional>

namespace billiards::server {

struct Session {
    Session(SessionId session, AddressKey address, base::Instant now, const LobbyLimits& limits)
        : id(session),
          from(address),
          heard(now),
          lobby_requests(limits.lobby_requests_per_10s, std::chrono::seconds(10)),
          chat(limits.chat_per_10s, std::chrono::seconds(10)),
          unsolvable(limits.unsolvable_per_min, std::chrono::minutes(1)) {}

    SessionId id;
    AddressKey from;
    Phase phase = Phase::Greeting;
    base::Instant heard;  ///< When its last message came; while Greeting: when it connected.
    std::optional<PlayerId> player;          ///< From Entering on.
    std::optional<protocol::TableId> table;  ///< Exactly while Watching or Seated.
    int illegal_messages = 0;
    int questions = 0;  ///< That the archive has not answered yet.
    RateLimit lobby_requests;
    RateLimit chat;
    RateLimit unsolvable;

    /// When it is closed, if it says nothing more.
    base::Instant expires() const {
        if (phase == Phase::Greeting) return heard + protocol::kGreetingTimeout;
        return heard + protocol::kIdleTimeout;
    }
};

}  // namespace billiards::server
