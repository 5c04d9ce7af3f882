// Takes what the game sends within one call; gives it to the network in one piece.
#pragma once

#include "server/net/network.h"

#include <asio/io_context.hpp>
#include <vector>

namespace billiards::server {

/// Lives on the game's thread. A shot for five thousand spectators crosses to the network's thread
/// once, and not five thousand times.
class BatchedOutbox final : public Outbox {
  public:
    BatchedOutbox(asio::io_context& network_context, Network& network)
        : network_context_(network_context), network_(network) {}

    void deliver(SessionId to, const protocol::SharedFrame& frame, Delivery delivery) override;
    void close(SessionId session) override;
    /// Answers one call of ConnectionEvents::received or malformed.
    void handled(SessionId session);
    /// Hands over what has gathered.
    void flush();

  private:
    asio::io_context& network_context_;
    Network& network_;
    std::vector<Outgoing> batch_;
};

}  // namespace billiards::server
