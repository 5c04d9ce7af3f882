// Takes one socket; gives what its client says, and sends what is for it, within limits of size,
// time and number.
#pragma once

#include "common/protocol/codec.h"
#include "common/protocol/framing.h"
#include "server/net/connection_events.h"
#include "server/net/listener.h"
#include "server/net/net_limits.h"
#include "server/net/net_stats.h"
#include "server/net/write_queue.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace billiards::server {

/// What all connections share; outlives them.
struct ConnectionShare {
    const NetLimits& limits;
    ConnectionEvents& events;
    NetStats& stats;
    protocol::SharedFrame preamble;        ///< Ours.
    std::function<void(SessionId)> ended;  ///< The connection may be forgotten.
    std::array<std::byte, 4096> unread{};  ///< Where bytes go that nobody wants any more.
};

/// Lives on the network's thread. Ten thousand of these wait at once, so one that is idle owns only
/// itself and one pending read: callbacks instead of a coroutine's frames, room for a header
/// instead of a buffer, and for the rest of a frame only while it is arriving.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    using Clock = std::chrono::steady_clock;

    Connection(Socket socket, SessionId session, AddressKey from, ConnectionShare& share);

    /// Sends our preamble and waits for theirs.
    void start();
    void deliver(const protocol::SharedFrame& frame, Delivery delivery);
    /// Sends what waits, then closes.
    void close();
    /// The game has dealt with one message.
    void handled();
    /// Looks at the deadline, and allows as many messages again as a tick has.
    void tick(Clock::time_point now);

  private:
    enum class Stage {
        Preamble,  ///< Theirs has not arrived; the game knows nothing of the session.
        Greeting,  ///< Nor their first message.
        Talking,
        Closing,  ///< What waits is still sent; what arrives is dropped. Over for the game.
        Closed,
    };

    static constexpr Clock::time_point kNever = Clock::time_point::max();

    bool is_over() const { return stage_ >= Stage::Closing; }
    void set_deadline(std::chrono::milliseconds from_now) { deadline_ = Clock::now() + from_now; }

    void read_preamble();
    void on_preamble();
    void read_header();
    void on_header();
    void read_frame();
    void on_frame();
    void read_next();
    void drop_what_arrives();
    void on_dropped(std::size_t bytes);
    void on_read_error();

    void write();
    void on_written(std::size_t frames, std::size_t bytes);
    void count_queued(std::size_t before);
    bool takes_nothing(Clock::time_point now);
    void end_if_all_is_sent();

    void refuse(protocol::RefusedCode code, std::string detail);
    void time_out();
    /// At once.
    void end();
    void tell_disconnected();

    Socket socket_;
    const SessionId session_;
    const AddressKey from_;
    ConnectionShare& share_;
    Clock::time_point deadline_;
    std::array<std::byte, protocol::kPreambleBytes> start_{};  ///< A preamble or a header.
    std::vector<std::byte> frame_;                             ///< Empty but while one arrives.
    WriteQueue queue_;
    Clock::time_point stalls_at_ = kNever;  ///< While a write is under way.
    int unsent_bytes_ = 0;                  ///< In the system's buffer, as of the last tick.
    int messages_in_flight_ = 0;
    int messages_allowed_;
    std::size_t dropped_bytes_ = 0;
    Stage stage_ = Stage::Preamble;
    bool reading_ = false;
    bool writing_ = false;
    bool reading_ended_ = false;  ///< They will say no more.
    bool sending_ended_ = false;  ///< Nor will we.
};

}  // namespace billiards::server
