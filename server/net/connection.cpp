// Takes one socket; gives what its client says, and sends what is for it, within limits of size,
// time and number.
#include "server/net/connection.h"

#include <asio/buffer.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <fmt/format.h>
#include <linux/sockios.h>
#include <span>
#include <string_view>
#include <sys/ioctl.h>
#include <utility>

namespace billiards::server {
namespace {

std::string not_within(std::string_view what, std::chrono::milliseconds limit) {
    return fmt::format("{} within {} s", what, std::chrono::duration<double>(limit).count());
}

}  // namespace

Connection::Connection(Socket socket, SessionId session, AddressKey from, ConnectionShare& share)
    : socket_(std::move(socket)),
      session_(session),
      from_(from),
      share_(share),
      queue_(share.limits.queued_bytes, share.limits.sheddable_bytes),
      messages_allowed_(share.limits.messages_per_tick) {}

void Connection::start() {
    asio::error_code ignored;  // A client that is gone already shows when it is read.
    socket_.set_option(asio::ip::tcp::no_delay(true), ignored);
    socket_.set_option(asio::socket_base::send_buffer_size(share_.limits.send_buffer_bytes),
                       ignored);
    set_deadline(share_.limits.greeting_timeout);
    deliver(share_.preamble, Delivery::Ordered);
    read_preamble();
}

void Connection::read_preamble() {
    reading_ = true;
    asio::async_read(socket_, asio::buffer(start_),
                     [self = shared_from_this()](const asio::error_code& error, std::size_t) {
                         self->reading_ = false;
                         error ? self->on_read_error() : self->on_preamble();
                     });
}

void Connection::on_preamble() {
    if (is_over()) return drop_what_arrives();
    const auto preamble = protocol::decode_preamble(start_);
    if (preamble) {
        stage_ = Stage::Greeting;
        share_.events.connected(session_, from_);
        return read_next();
    }
    ++share_.stats.malformed;
    // Another version reads this; for anything else it is at least a sentence among the bytes.
    refuse(protocol::RefusedCode::Malformed, preamble.error().detail);
}

void Connection::read_next() {
    if (is_over()) return drop_what_arrives();
    const bool may_read =
        messages_in_flight_ < share_.limits.messages_in_flight && messages_allowed_ > 0;
    if (may_read) read_header();
}

void Connection::read_header() {
    reading_ = true;
    asio::async_read(socket_, asio::buffer(start_, protocol::kFrameHeaderBytes),
                     [self = shared_from_this()](const asio::error_code& error, std::size_t) {
                         self->reading_ = false;
                         error ? self->on_read_error() : self->on_header();
                     });
}

void Connection::on_header() {
    if (is_over()) return drop_what_arrives();
    const std::size_t max_bytes = stage_ == Stage::Greeting ? protocol::kMaxGreetingFrameBytes
                                                            : protocol::kMaxClientFrameBytes;
    const auto header = std::span(start_).first<protocol::kFrameHeaderBytes>();
    const auto frame_bytes = protocol::decode_frame_header(header, max_bytes);
    if (!frame_bytes) {
        // Where the next frame begins is unknown now, so this cannot go on.
        ++share_.stats.malformed;
        return refuse(protocol::RefusedCode::Malformed, frame_bytes.error().detail);
    }
    frame_.resize(*frame_bytes);
    // Before the first message the deadline stays: however much is sent, a greeting has its time.
    if (stage_ == Stage::Talking) set_deadline(share_.limits.frame_timeout);
    read_frame();
}

void Connection::read_frame() {
    reading_ = true;
    asio::async_read(socket_, asio::buffer(frame_),
                     [self = shared_from_this()](const asio::error_code& error, std::size_t) {
                         self->reading_ = false;
                         error ? self->on_read_error() : self->on_frame();
                     });
}

void Connection::on_frame() {
    if (is_over()) return drop_what_arrives();
    auto message = protocol::decode_client(frame_);
    ++share_.stats.frames_in;
    share_.stats.bytes_in += protocol::kFrameHeaderBytes + frame_.size();
    frame_ = {};
    ++messages_in_flight_;
    --messages_allowed_;
    if (message) {
        stage_ = Stage::Talking;
        share_.events.received(session_, std::move(message).value());
    } else {
        ++share_.stats.malformed;
        share_.events.malformed(session_, std::move(message).error().detail);
    }
    if (stage_ == Stage::Talking) deadline_ = kNever;
    read_next();
}

void Connection::handled() {
    --messages_in_flight_;
    if (!reading_ && !is_over()) read_next();
}

void Connection::tick(Clock::time_point now) {
    messages_allowed_ = share_.limits.messages_per_tick;
    if (now >= deadline_) return time_out();
    if (writing_ && !is_over() && takes_nothing(now)) {
        ++share_.stats.stalled;
        return end();
    }
    if (!reading_ && !is_over()) read_next();
}

/// While one write is under way nothing is added to the system's buffer once that is full: where it
/// does not shrink, the receiver takes nothing.
bool Connection::takes_nothing(Clock::time_point now) {
    int unsent_bytes = 0;
    if (::ioctl(socket_.native_handle(), SIOCOUTQ, &unsent_bytes) != 0) return false;
    const bool moves = std::exchange(unsent_bytes_, unsent_bytes) != unsent_bytes;
    if (moves || stalls_at_ == kNever) stalls_at_ = now + share_.limits.stalled_timeout;
    return now >= stalls_at_;
}

void Connection::time_out() {
    if (stage_ == Stage::Closing) return end();
    ++share_.stats.timed_out;
    if (stage_ == Stage::Preamble || stage_ == Stage::Greeting) {
        return refuse(protocol::RefusedCode::GreetingTimeout,
                      not_within("no greeting", share_.limits.greeting_timeout));
    }
    refuse(protocol::RefusedCode::IdleTimeout,
           not_within("a frame was begun and not ended", share_.limits.frame_timeout));
}

void Connection::deliver(const protocol::SharedFrame& frame, Delivery delivery) {
    if (is_over()) return;
    const std::size_t before = queue_.bytes();
    const WriteQueue::Pushed pushed = queue_.push(frame, delivery);
    count_queued(before);
    share_.stats.shed += pushed.shed;
    if (!pushed.fits) {
        ++share_.stats.too_slow;
        return end();
    }
    if (!writing_ && !queue_.nothing_waits()) write();
}

void Connection::count_queued(std::size_t before) {
    share_.stats.queued_bytes += queue_.bytes();
    share_.stats.queued_bytes -= before;
}

void Connection::write() {
    auto frames = queue_.take();
    std::vector<asio::const_buffer> buffers;
    buffers.reserve(frames.size());
    for (const protocol::SharedFrame& frame : frames) buffers.push_back(asio::buffer(*frame));
    writing_ = true;
    asio::async_write(socket_, std::move(buffers),
                      [self = shared_from_this(), held = std::move(frames)](
                          const asio::error_code& error, std::size_t bytes) {
                          self->writing_ = false;
                          error ? self->end() : self->on_written(held.size(), bytes);
                      });
}

void Connection::on_written(std::size_t frames, std::size_t bytes) {
    share_.stats.frames_out += frames;
    share_.stats.bytes_out += bytes;
    const std::size_t before = queue_.bytes();
    queue_.written();
    if (stage_ == Stage::Closed) return;
    count_queued(before);
    stalls_at_ = kNever;
    if (!is_over() && queue_.tell_fell_behind()) {
        ++share_.stats.fell_behind;
        share_.events.fell_behind(session_);
    }
    if (!queue_.nothing_waits()) return write();
    if (stage_ == Stage::Closing) end_if_all_is_sent();
}

void Connection::refuse(protocol::RefusedCode code, std::string detail) {
    protocol::server::Refused refused;
    refused.code = code;
    refused.detail = std::move(detail);
    deliver(protocol::encode(protocol::ServerMessage(std::move(refused))), Delivery::Ordered);
    close();
}

void Connection::close() {
    if (is_over()) return;
    tell_disconnected();
    stage_ = Stage::Closing;
    set_deadline(share_.limits.closing_timeout);
    if (!reading_) drop_what_arrives();
    if (!writing_) end_if_all_is_sent();
}

/// Reading on until they close too: with unread bytes the system would cut the connection, and
/// with it the last frame on its way to them.
void Connection::drop_what_arrives() {
    if (stage_ == Stage::Closed) return;
    frame_ = {};
    reading_ = true;
    socket_.async_read_some(
        asio::buffer(share_.unread),
        [self = shared_from_this()](const asio::error_code& error, std::size_t bytes) {
            self->reading_ = false;
            error ? self->on_read_error() : self->on_dropped(bytes);
        });
}

/// Whoever says so much after the end does not listen.
void Connection::on_dropped(std::size_t bytes) {
    dropped_bytes_ += bytes;
    dropped_bytes_ < share_.limits.dropped_bytes ? drop_what_arrives() : on_read_error();
}

void Connection::on_read_error() {
    if (stage_ != Stage::Closing) return end();
    reading_ended_ = true;
    if (sending_ended_) end();
}

void Connection::end_if_all_is_sent() {
    sending_ended_ = true;
    asio::error_code ignored;  // They may be gone; then reading ends at once.
    socket_.shutdown(Socket::shutdown_send, ignored);
    if (reading_ended_) end();
}

void Connection::end() {
    if (stage_ == Stage::Closed) return;
    tell_disconnected();
    stage_ = Stage::Closed;
    share_.stats.queued_bytes -= queue_.bytes();
    asio::error_code ignored;
    socket_.close(ignored);
    share_.ended(session_);
}

void Connection::tell_disconnected() {
    const bool known_to_the_game = stage_ == Stage::Greeting || stage_ == Stage::Talking;
    if (known_to_the_game) share_.events.disconnected(session_);
}

}  // namespace billiards::server
