// Takes an address; gives a connection: a coroutine that connects and reads, a queue that writes,
// and a timer that watches both.
#include "client/net/link.h"

#include "client/net/clock.h"
#include "client/net/frame_buffer.h"
#include "common/protocol/codec.h"
#include "common/protocol/framing.h"
#include "common/protocol/limits.h"

#include <algorithm>
#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>
#include <asio/connect.hpp>
#include <asio/detached.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/read.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>
#include <fmt/format.h>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace billiards::client {

namespace {

using asio::ip::tcp;

constexpr int kEarlyPings = 3;
constexpr base::Duration kEarlyPingInterval = std::chrono::seconds(1);

Lost connect_failure(const asio::error_code& error, const ServerAddress& address) {
    if (error == asio::error::connection_refused) {
        return {LostCode::ConnectionRefused,
                fmt::format("connection refused: nothing listens at {}", to_text(address))};
    }
    return {LostCode::Unreachable,
            fmt::format("cannot reach {}: {}", to_text(address), error.message())};
}

Lost preamble_failure(const protocol::FramingError& error, const ServerAddress& address) {
    if (error.code == protocol::FramingErrorCode::OtherVersion) {
        return {LostCode::OtherVersion, "another version of the protocol: " + error.detail};
    }
    return {LostCode::NotAServer, fmt::format("{} is not a gl-billiards server", to_text(address))};
}

}  // namespace

class Link::Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(const asio::any_io_executor& executor, ServerAddress address, Callbacks callbacks,
               const LinkLimits& limits)
        : executor_(executor),
          address_(std::move(address)),
          callbacks_(std::move(callbacks)),
          limits_(limits),
          resolver_(executor),
          socket_(executor),
          timer_(executor),
          resumed_(executor) {}

    void start() {
        asio::co_spawn(
            executor_, [self = shared_from_this()] { return self->run(); }, asio::detached);
    }

    void close() {
        is_over_ = true;
        asio::error_code ignored;
        socket_.close(ignored);
        resolver_.cancel();
        timer_.cancel();
        resumed_.cancel();
    }

    void send(const protocol::ClientMessage& message, Written written);
    void keep_alive();
    void pause_reading() { is_paused_ = true; }
    void resume_reading() {
        is_paused_ = false;
        heard_at_ = local_now();
        resumed_.cancel();
    }

  private:
    asio::awaitable<void> run();
    asio::awaitable<std::optional<Lost>> connect();
    asio::awaitable<std::optional<Lost>> exchange_preambles();
    asio::awaitable<Lost> read_frames();
    std::optional<Lost> take_frames();
    std::optional<Lost> take_frame(std::span<const std::byte> frame);
    void finish(const Lost& lost);
    void write_next();
    void watch_over(base::Duration interval);
    void look_after();

    struct Waiting {
        protocol::SharedFrame frame;
        Written written;
    };

    asio::any_io_executor executor_;
    ServerAddress address_;
    Callbacks callbacks_;
    LinkLimits limits_;
    tcp::resolver resolver_;
    tcp::socket socket_;
    asio::steady_timer timer_;    ///< Connecting: the timeout. Then: pings and silence.
    asio::steady_timer resumed_;  ///< Never expires: cancelled when reading may go on.
    bool is_over_ = false;
    bool is_connected_ = false;
    bool has_timed_out_ = false;
    bool is_paused_ = false;
    bool is_keeping_alive_ = false;
    int pings_sent_ = 0;
    base::Instant heard_at_{};
    FrameBuffer frames_{protocol::kMaxServerFrameBytes};
    std::vector<Waiting> waiting_;    ///< To be written.
    std::vector<Waiting> in_flight_;  ///< Being written.
    std::size_t waiting_bytes_ = 0;   ///< Of both.
};

asio::awaitable<void> Link::Connection::run() {
    timer_.expires_after(limits_.connect_timeout);
    timer_.async_wait([self = shared_from_this()](const asio::error_code& error) {
        if (error || self->is_connected_ || self->is_over_) return;
        self->has_timed_out_ = true;
        self->resolver_.cancel();
        asio::error_code ignored;
        self->socket_.close(ignored);
    });
    std::optional<Lost> failure = co_await connect();
    if (!failure) failure = co_await exchange_preambles();
    if (has_timed_out_) {
        failure = Lost{LostCode::NoAnswer, fmt::format("no answer from {}", to_text(address_))};
    }
    if (failure) {
        finish(*failure);
        co_return;
    }
    if (is_over_) co_return;
    is_connected_ = true;
    heard_at_ = local_now();
    watch_over(limits_.ping_interval);
    callbacks_.connected();
    write_next();
    const Lost lost = co_await read_frames();
    finish(lost);
}

asio::awaitable<std::optional<Lost>> Link::Connection::connect() {
    asio::error_code error;
    auto token = asio::redirect_error(asio::use_awaitable, error);
    const asio::ip::address numeric = asio::ip::make_address(address_.host, error);
    if (!error) {
        co_await socket_.async_connect(tcp::endpoint(numeric, address_.port), token);
    } else {
        const auto endpoints = co_await resolver_.async_resolve(
            address_.host, std::to_string(address_.port), tcp::resolver::numeric_service, token);
        if (error) {
            co_return Lost{LostCode::UnknownHost, fmt::format("unknown host: {}", address_.host)};
        }
        // The timeout may have come between the last line and this one.
        if (has_timed_out_ || is_over_) co_return Lost{};
        co_await asio::async_connect(socket_, endpoints, token);
    }
    if (error) co_return connect_failure(error, address_);
    socket_.set_option(tcp::no_delay(true), error);
    co_return std::nullopt;
}

asio::awaitable<std::optional<Lost>> Link::Connection::exchange_preambles() {
    asio::error_code error;
    auto token = asio::redirect_error(asio::use_awaitable, error);
    const protocol::PreambleBytes ours = protocol::encode_preamble({});
    co_await asio::async_write(socket_, asio::buffer(ours), token);
    protocol::PreambleBytes theirs{};
    if (!error) co_await asio::async_read(socket_, asio::buffer(theirs), token);
    if (error == asio::error::eof || error == asio::error::connection_reset ||
        error == asio::error::broken_pipe) {
        co_return Lost{LostCode::Closed,
                       fmt::format("{} closed the connection at once", to_text(address_))};
    }
    if (error) co_return connect_failure(error, address_);
    const auto preamble = protocol::decode_preamble(theirs);
    if (!preamble) co_return preamble_failure(preamble.error(), address_);
    co_return std::nullopt;
}

asio::awaitable<Lost> Link::Connection::read_frames() {
    while (true) {
        asio::error_code error;
        auto token = asio::redirect_error(asio::use_awaitable, error);
        if (is_paused_) {
            resumed_.expires_at(asio::steady_timer::time_point::max());
            co_await resumed_.async_wait(token);
            if (is_over_) co_return Lost{};
            continue;
        }
        const std::span<std::byte> room = frames_.room();
        frames_.add(
            co_await socket_.async_read_some(asio::buffer(room.data(), room.size()), token));
        if (error) co_return Lost{LostCode::Closed, "the server closed the connection"};
        heard_at_ = local_now();
        const std::optional<Lost> failure = take_frames();
        if (failure) co_return *failure;
    }
}

/// Every whole frame that was read.
std::optional<Lost> Link::Connection::take_frames() {
    while (!is_over_) {
        const auto frame = frames_.next();
        if (!frame) {
            return Lost{LostCode::Malformed,
                        "the server sent a frame of an impossible length: " + frame.error().detail};
        }
        if (!*frame) return std::nullopt;
        const std::optional<Lost> failure = take_frame(**frame);
        if (failure) return failure;
    }
    return Lost{};
}

std::optional<Lost> Link::Connection::take_frame(std::span<const std::byte> frame) {
    auto message = protocol::decode_server(frame);
    if (message) {
        callbacks_.message(std::move(message).value(), protocol::kFrameHeaderBytes + frame.size());
        return std::nullopt;
    }
    // A newer server may say what this program does not know yet; it goes on without it.
    if (message.error().code == protocol::DecodeErrorCode::UnknownKind) return std::nullopt;
    return Lost{LostCode::Malformed,
                "the server sent what is no message: " + message.error().detail};
}

void Link::Connection::finish(const Lost& lost) {
    if (is_over_) return;
    close();
    callbacks_.lost(lost);
}

void Link::Connection::send(const protocol::ClientMessage& message, Written written) {
    if (is_over_) return;
    protocol::SharedFrame frame = protocol::encode(message);
    waiting_bytes_ += frame->size();
    if (waiting_bytes_ > limits_.max_waiting_bytes) {
        // Not from within send: the caller is in the middle of something.
        asio::post(executor_, [self = shared_from_this()] {
            self->finish({LostCode::TooMuchWaiting, "the server does not take what it is sent"});
        });
        return;
    }
    waiting_.push_back({std::move(frame), std::move(written)});
    write_next();
}

void Link::Connection::write_next() {
    if (!is_connected_ || !in_flight_.empty() || waiting_.empty()) return;
    in_flight_.swap(waiting_);
    std::vector<asio::const_buffer> buffers;
    buffers.reserve(in_flight_.size());
    for (const Waiting& waiting : in_flight_) buffers.push_back(asio::buffer(*waiting.frame));
    asio::async_write(
        socket_, buffers,
        [self = shared_from_this()](const asio::error_code& error, std::size_t bytes) {
            // A broken link is noticed, and told of, by whoever reads.
            if (error || self->is_over_) return;
            self->waiting_bytes_ -= bytes;
            const std::vector<Waiting> done = std::exchange(self->in_flight_, {});
            for (const Waiting& sent : done) {
                if (sent.written) sent.written();
            }
            self->write_next();
        });
}

void Link::Connection::keep_alive() {
    is_keeping_alive_ = true;
    pings_sent_ = 0;
    look_after();
}

void Link::Connection::watch_over(base::Duration interval) {
    timer_.expires_after(interval);
    timer_.async_wait([self = shared_from_this()](const asio::error_code& error) {
        if (!error && !self->is_over_) self->look_after();
    });
}

void Link::Connection::look_after() {
    const base::Instant now = local_now();
    if (!is_paused_ && now - heard_at_ > limits_.max_silence) {
        finish({LostCode::NoAnswer, fmt::format("{} does not answer any more", to_text(address_))});
        return;
    }
    if (is_keeping_alive_) {
        ++pings_sent_;
        const auto now_us = now.time_since_epoch().count();
        send({.request_id = 0, .body = protocol::client::Ping{now_us}}, nullptr);
    }
    const bool is_early = is_keeping_alive_ && pings_sent_ < kEarlyPings;
    watch_over(is_early ? std::min(kEarlyPingInterval, limits_.ping_interval)
                        : limits_.ping_interval);
}

Link::Link(const asio::any_io_executor& executor, ServerAddress address, Callbacks callbacks,
           const LinkLimits& limits)
    : connection_(std::make_shared<Connection>(executor, std::move(address), std::move(callbacks),
                                               limits)) {
    connection_->start();
}

Link::~Link() {
    if (connection_) connection_->close();
}

Link::Link(Link&&) noexcept = default;

Link& Link::operator=(Link&& other) noexcept {
    if (connection_) connection_->close();
    connection_ = std::move(other.connection_);
    return *this;
}

void Link::send(const protocol::ClientMessage& message, Written written) {
    connection_->send(message, std::move(written));
}

void Link::keep_alive() {
    connection_->keep_alive();
}

void Link::pause_reading() {
    connection_->pause_reading();
}

void Link::resume_reading() {
    connection_->resume_reading();
}

}  // namespace billiards::client
