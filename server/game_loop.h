// Takes what the network and the store have to say; runs the lobby with it on the game's thread,
// and wakes it when its time has come.
#pragma once

#include "server/lobby/lobby.h"
#include "server/net/batched_outbox.h"
#include "server/net/connection_events.h"

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <optional>

namespace billiards::server {

/// Every call may come from any thread and returns at once.
class GameLoop final : public ConnectionEvents {
  public:
    /// The server's clock starts here.
    explicit GameLoop(asio::io_context& context) : context_(context), timer_(context) {}

    /// Once, before the io_context runs; both must live until it no longer does.
    void attach(Lobby& lobby, BatchedOutbox& outbox);

    /// Runs the call on the game's thread; afterwards what it sent goes out.
    void run(std::function<void(Lobby&, base::Instant)> call);

    void connected(SessionId session, AddressKey from) override;
    void received(SessionId session, protocol::ClientMessage message) override;
    void malformed(SessionId session, std::string detail) override;
    void fell_behind(SessionId session) override;
    void disconnected(SessionId session) override;

    base::Instant now() const;

  private:
    using Clock = std::chrono::steady_clock;

    void settle();
    void wake_at(base::Instant when);

    asio::io_context& context_;
    asio::steady_timer timer_;
    const Clock::time_point start_ = Clock::now();
    std::optional<base::Instant> wakes_at_;
    Lobby* lobby_ = nullptr;
    BatchedOutbox* outbox_ = nullptr;
};

}  // namespace billiards::server
