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
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace billiards::tools {

struct LoadSessionOptions {
    client::ServerAddress address;
    std::string name;
    std::uint64_t seed = 0;
    std::optional<PlayerOptions> player;  ///< None: a spectator of `table`.
    PlayerEvents events;                  ///< Of the player.
    protocol::TableId table;              ///< To watch.
    bool stops_reading_when_in_place = false;
    /// A spectator that asks for more than the system's buffers hold, and reads none of it.
    bool stalls = false;
    /// How long a link is kept before it is dropped and made again; zero: for ever.
    base::Duration drops_after{};
    std::function<void()> shot_sent;  ///< The last byte of a shot was given to the system; or null.
};

/// A spectator keeps no state but where it is: thousands of them must fit into one process.
class LoadSession {
  public:
    /// `in_place` is called when it has got its place at a table, the first time only.
    LoadSession(asio::io_context& io, LoadSessionOptions options, Recorder& recorder,
                std::function<void(protocol::TableId)> in_place);
    LoadSession(const LoadSession&) = delete;
    LoadSession& operator=(const LoadSession&) = delete;

    /// It has had a place at its table, and may have lost its link since.
    bool is_in_place() const { return is_in_place_; }
    /// It has its place now, as far as it knows.
    bool is_here() const { return is_here_; }
    /// Its player has nothing more to do.
    bool is_finished() const { return player_ && player_->is_finished(); }
    /// Why it cannot go on; empty while it can.
    const std::string& failure() const { return failure_; }
    int links_lost() const { return links_lost_; }
    /// Must have a player.
    const HeadlessPlayer& player() const { return *player_; }

  private:
    void connect();
    std::uint32_t send(protocol::ClientMessageBody body);
    void received(const protocol::ServerMessage& message, std::size_t frame_bytes);
    void on_welcome(const protocol::server::Welcome& welcome, base::Instant now);
    void stall(base::Instant now);
    void on_place(protocol::TableId table, base::Instant now);
    void lost(const client::Lost& lost);
    void give_up(const std::string& why);
    void gone();
    /// Calls it then, unless the timer is set anew or this object is gone.
    void call_after(asio::steady_timer& timer, base::Duration delay, void (LoadSession::*what)());
    void connect_after(base::Duration delay);
    void drop_later();
    void drop();
    void act();
    void wait_for_player();

    LoadSessionOptions options_;
    Recorder& recorder_;
    std::function<void(protocol::TableId)> in_place_;
    client::Reconnect reconnect_;
    base::Random random_;
    asio::io_context& io_;
    /// Gone with this object: a timer that has fired is called though the timer is gone.
    std::shared_ptr<const std::monostate> alive_ = std::make_shared<const std::monostate>();
    asio::steady_timer retry_;
    asio::steady_timer drop_;
    asio::steady_timer act_;
    std::optional<HeadlessPlayer> player_;
    std::uint32_t last_request_id_ = 0;
    std::optional<base::Instant> gone_since_;  ///< It lost its place with its link.
    bool is_welcome_ = false;
    bool is_in_place_ = false;
    bool is_here_ = false;
    int links_lost_ = 0;
    std::string failure_;
    std::optional<client::Link> link_;  ///< Last: its end is the end of every callback.
};

}  // namespace billiards::tools
