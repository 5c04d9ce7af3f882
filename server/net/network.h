// Takes addresses to listen on; gives sessions to the game, and carries out what it sends them.
#pragma once

#include "server/net/connection.h"

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <spdlog/logger.h>
#include <unordered_map>
#include <vector>

namespace billiards::server {

/// One thing that the game wants done.
struct Outgoing {
    enum class Kind : std::uint8_t {
        Ordered,
        LatestWins,
        Sheddable,
        Fresh,
        Close,    ///< Once everything before it is sent.
        Handled,  ///< A message of the session has been dealt with.
    };
    SessionId session;
    Kind kind = Kind::Ordered;
    protocol::SharedFrame frame;  ///< Of the first four kinds.
};

/// Lives on the thread that runs the io_context; made and told to listen before that runs.
class Network {
  public:
    Network(asio::io_context& context, const NetLimits& limits, ConnectionEvents& events,
            spdlog::logger& log);
    Network(const Network&) = delete;
    Network& operator=(const Network&) = delete;

    /// Gives the address with the port that was taken; throws as Listener does.
    Endpoint listen(const Endpoint& endpoint);
    void start();

    /// In order. What is for a session that is gone is dropped.
    void carry_out(const std::vector<Outgoing>& batch);
    const NetStats& stats() const { return stats_; }

    /// Takes no one in any more, sends each what waits and closes; `stopped` is called when the
    /// last is gone.
    void stop(std::function<void()> stopped);

  private:
    struct Entry {
        std::shared_ptr<Connection> connection;
        AddressKey address;
        bool is_turned_away = false;  ///< It is only told so.
    };

    void accepted(Socket socket);
    void turn_away(Socket socket);
    Connection& add(Socket socket, AddressKey address, bool is_turned_away);
    std::size_t guests() const { return connections_.size() - turned_away_; }
    void ended(SessionId session);
    void wait_for_tick();
    void tick();

    asio::io_context& context_;
    const NetLimits limits_;
    const std::size_t max_connections_;
    spdlog::logger& log_;
    NetStats stats_;
    ConnectionShare share_;
    AddressLimits addresses_;
    std::vector<std::unique_ptr<Listener>> listeners_;
    std::unordered_map<std::uint64_t, Entry> connections_;  ///< By session.
    std::size_t turned_away_ = 0;                           ///< Of these.
    std::uint64_t last_session_ = 0;
    asio::steady_timer tick_timer_;
    std::function<void()> stopped_;
};

}  // namespace billiards::server
