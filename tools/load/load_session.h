// Takes an executor and what one client is to do; gives that client: a link that is made again when
// it is lost, and a player or a spectator on it.
#pragma once

#include "client/net/address.h"
#include "client/net/link.h"
#include "client/net/reconnect.h"
#include "common/protocol/messages.h"
#include "tools/load/recorder.h"
#include "tools/player/headless_player.h"

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace billiards::tools {

struct LoadSessionOptions {
    client::ServerAddress address;
    std::string name;
    std::uint64_t seed = 0;
    std::optional<PlayerOptions> player;  ///< None: a spectator of `table`.
    protocol::TableId table;              ///< To watch.
    bool stops_reading_when_in_place = false;
    /// How long a link is kept before it is dropped and made again; zero: for ever.
    base::Duration drops_after{};
};

/// A spectator keeps no state but where it is: thousands of them must fit into one process.
class LoadSession {
  public:
    /// `in_place` is called when it has got its place at a table, the first time only.
    LoadSession(asio::io_context& io, LoadSessionOptions options, Recorder& recorder,
                std::function<void(protocol::TableId)> in_place);
    LoadSession(const LoadSession&) = delete;
    LoadSession& operator=(const LoadSession&) = delete;

    bool is_in_place() const { return is_in_place_; }

  private:
    void connect();
    std::uint32_t send(protocol::ClientMessageBody body);
    void received(const protocol::ServerMessage& message, std::size_t frame_bytes);
    void on_welcome(const protocol::server::Welcome& welcome, base::Instant now);
    void on_place(protocol::TableId table);
    void lost(const client::Lost& lost);
    void gone();
    void connect_after(base::Duration delay);
    void drop_later();
    void wait_for_player();

    LoadSessionOptions options_;
    Recorder& recorder_;
    std::function<void(protocol::TableId)> in_place_;
    client::Reconnect reconnect_;
    base::Random random_;
    asio::io_context& io_;
    asio::steady_timer retry_;
    asio::steady_timer drop_;
    asio::steady_timer act_;
    std::optional<HeadlessPlayer> player_;
    std::uint32_t last_request_id_ = 0;
    std::optional<base::Instant> gone_since_;  ///< The link was lost after a Welcome.
    bool is_welcome_ = false;
    bool is_in_place_ = false;
    std::optional<client::Link> link_;  ///< Last: its end is the end of every callback.
};

}  // namespace billiards::tools
