// Gives the one way in which tables and sessions know the network: frames out, by session.
#pragma once

#include "common/protocol/codec.h"

#include <cstdint>
#include <string>

namespace billiards::server {

/// One connection, for as long as it lasts; never used again.
struct SessionId {
    std::uint64_t value = 0;
    friend auto operator<=>(SessionId, SessionId) = default;
};

enum class Delivery : std::uint8_t {
    Ordered,     ///< Arrives, after everything before it, or the session is closed.
    LatestWins,  ///< An aim: replaced by a newer one while it waits, dropped first under load.
    /// To spectators: in order, but one who is too far behind loses everything of this kind that
    /// waits, and gets no more of it until a Fresh frame. The network then says fell_behind, once
    /// what was being written is out.
    Sheddable,
    Fresh,  ///< A snapshot, after which nothing that was shed is missed. Otherwise as Sheddable.
};

class Outbox {
  public:
    virtual ~Outbox() = default;

    /// Takes a share of the frame and returns at once; an unknown or closed session is ignored.
    virtual void deliver(SessionId to, const protocol::SharedFrame& frame, Delivery delivery) = 0;
    /// Sends what waits, then closes.
    virtual void close(SessionId session) = 0;
};

}  // namespace billiards::server
