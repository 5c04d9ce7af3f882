// Takes an address and an executor; gives one connection to a server: messages out and in, and at
// the end the reason why it was lost.
#pragma once

#include "client/net/address.h"
#include "client/net/lost.h"
#include "common/base/time.h"
#include "common/protocol/messages.h"

#include <asio/any_io_executor.hpp>
#include <cstddef>
#include <functional>
#include <memory>

namespace billiards::client {

struct LinkLimits {
    base::Duration connect_timeout = std::chrono::seconds(10);  ///< Until the server's preamble.
    base::Duration ping_interval = std::chrono::seconds(15);
    /// Without a byte from the server for so long, the link counts as lost.
    base::Duration max_silence = std::chrono::seconds(45);
    std::size_t max_waiting_bytes = 256 * 1024;  ///< To be sent.
};

/// All calls and all callbacks happen on the executor, which must run one handler at a time.
class Link {
  public:
    struct Callbacks {
        std::function<void()> connected;  ///< Both preambles were exchanged.
        /// frame_bytes: what it took on the wire, with the length header.
        std::function<void(protocol::ServerMessage&& message, std::size_t frame_bytes)> message;
        std::function<void(const Lost& lost)> lost;  ///< At most once, and nothing after it.
    };
    /// Called once the last byte of a message was given to the system; never if the link is lost.
    using Written = std::function<void()>;

    /// Starts to connect; no callback comes from within the constructor.
    Link(const asio::any_io_executor& executor, ServerAddress address, Callbacks callbacks,
         const LinkLimits& limits = {});
    /// Closes; no callback comes after it.
    ~Link();
    Link(Link&&) noexcept;
    Link& operator=(Link&&) noexcept;

    /// Sends what waits before it first. After the link is lost it does nothing.
    void send(const protocol::ClientMessage& message, Written written = nullptr);
    /// From the Welcome on: pings the server, at first more often, so that its clock is known soon
    /// and it never takes this client for an idle one.
    void keep_alive();
    /// Once the read that is under way is done, leaves what arrives to the system's buffers, and
    /// then to the server's. For a caller that has enough to do, and for slow receivers on purpose.
    void pause_reading();
    void resume_reading();

  private:
    class Connection;
    std::shared_ptr<Connection> connection_;
};

}  // namespace billiards::client
