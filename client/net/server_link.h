// Takes an address and a name; gives one session with a server on an I/O thread of its own, made
// again when it is lost, and one queue of what arrived for the caller's thread.
#pragma once

#include "client/net/address.h"
#include "client/net/link.h"
#include "client/net/lost.h"
#include "client/net/reconnect.h"
#include "common/base/time.h"
#include "common/protocol/messages.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace billiards::client {

struct Arrived {
    protocol::ServerMessage message;
    base::Instant at;  ///< On the local clock, when it was read.
};

struct LinkLost {
    Lost lost;
    std::optional<base::Duration> retry_after;  ///< None: it is final, and nothing comes any more.
};

using LinkEvent = std::variant<Arrived, LinkLost>;

/// What waits for the caller; beyond it, reading pauses and the server is left to wait.
inline constexpr std::size_t kMaxWaitingEvents = 1024;

struct ServerLinkOptions {
    ServerAddress address;
    std::string name;
    std::optional<protocol::ResumeToken> token;  ///< Of an earlier session, to come back to it.
    std::uint64_t seed = 0;                      ///< Of the jitter between attempts.
    LinkLimits limits;
    ReconnectLimits reconnect;
};

/// It greets by itself, keeps the session alive by itself, and says again by itself what was not
/// answered when the link was lost: everything of which may_be_repeated() is true. Everything may
/// be called from any one thread at a time.
class ServerLink {
  public:
    explicit ServerLink(ServerLinkOptions options);
    /// Closes the connection and joins the thread.
    ~ServerLink();
    ServerLink(const ServerLink&) = delete;
    ServerLink& operator=(const ServerLink&) = delete;

    /// Gives the request_id that a refusal will name. What may not be repeated is not kept while
    /// the link is down: of that, decide anew once the table is known again.
    std::uint32_t send(protocol::ClientMessageBody body);

    /// The next event, if one waits.
    std::optional<LinkEvent> poll();
    /// The next event, or none when `duration` has passed.
    std::optional<LinkEvent> wait_for(base::Duration duration);

  private:
    class Session;
    std::unique_ptr<Session> session_;
};

}  // namespace billiards::client
