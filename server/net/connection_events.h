// Gives what the network tells the game.
#pragma once

#include "common/protocol/messages.h"
#include "server/session/address_key.h"
#include "server/table/outbox.h"

#include <string>

namespace billiards::server {

/// Called on the network's thread, a session's calls in the order in which things happened.
/// Whoever is called must hand the event on and return.
class ConnectionEvents {
  public:
    virtual ~ConnectionEvents() = default;

    /// A client that speaks this protocol's version; the first call about the session.
    virtual void connected(SessionId session, AddressKey from) = 0;
    /// Owes Outgoing::Handled in return, as malformed() does.
    virtual void received(SessionId session, protocol::ClientMessage message) = 0;
    /// A whole frame that holds no message; the session goes on.
    virtual void malformed(SessionId session, std::string detail) = 0;
    /// A spectator lost frames that could be shed, and everything written before is out: what
    /// brings it up to date is a frame delivered as Fresh. Once for each time that it falls behind.
    virtual void fell_behind(SessionId session) = 0;
    /// The last call about the session, also where the game asked for its end.
    virtual void disconnected(SessionId session) = 0;
};

}  // namespace billiards::server
