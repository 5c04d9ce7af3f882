// Takes messages from the caller's thread to the I/O thread and back, and makes a lost link again.
#include "client/net/server_link.h"

#include "client/net/clock.h"

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace billiards::client {

namespace {

/// From the I/O thread to the caller's.
class EventQueue {
  public:
    /// Whether it is full now.
    bool push(LinkEvent event) {
        const std::lock_guard lock(mutex_);
        events_.push_back(std::move(event));
        arrived_.notify_one();
        return events_.size() >= kMaxWaitingEvents;
    }

    struct Popped {
        std::optional<LinkEvent> event;
        bool is_half_empty_now = false;  ///< By this call: reading may go on.
    };
    Popped pop(base::Duration wait) {
        std::unique_lock lock(mutex_);
        arrived_.wait_for(lock, wait, [this] { return !events_.empty(); });
        if (events_.empty()) return {};
        Popped popped{.event = std::move(events_.front())};
        events_.pop_front();
        popped.is_half_empty_now = events_.size() == kMaxWaitingEvents / 2;
        return popped;
    }

  private:
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::deque<LinkEvent> events_;
};

}  // namespace

class ServerLink::Session {
  public:
    explicit Session(ServerLinkOptions options)
        : options_(std::move(options)),
          reconnect_(options_.name, options_.token, options_.seed, options_.reconnect),
          retry_(io_) {
        connect();
        thread_ = std::thread([this] { io_.run(); });
    }

    ~Session() {
        asio::post(io_, [this] {
            link_.reset();
            retry_.cancel();
            work_.reset();
        });
        thread_.join();
    }

    std::uint32_t send(protocol::ClientMessageBody body) {
        const std::uint32_t id = ++last_request_id_;
        asio::post(io_, [this, message = protocol::ClientMessage{id, std::move(body)}] {
            const bool is_for_now = reconnect_.sent(message);
            if (is_for_now && is_welcome_) link_->send(message);
        });
        return id;
    }

    std::optional<LinkEvent> next(base::Duration wait) {
        EventQueue::Popped popped = events_.pop(wait);
        if (popped.is_half_empty_now) {
            asio::post(io_, [this] {
                if (link_) link_->resume_reading();
            });
        }
        return std::move(popped.event);
    }

  private:
    // From here on, everything happens on the I/O thread; but the first connect, before it starts.
    void connect() {
        Link::Callbacks callbacks;
        callbacks.connected = [this] {
            link_->send({.request_id = 0, .body = reconnect_.hello()});
        };
        callbacks.message = [this](protocol::ServerMessage&& message, std::size_t) {
            received(std::move(message));
        };
        callbacks.lost = [this](const Lost& lost) { this->lost(lost); };
        link_.emplace(io_.get_executor(), options_.address, std::move(callbacks), options_.limits);
    }

    void received(protocol::ServerMessage&& message) {
        const base::Instant now = local_now();
        reconnect_.received(message, now);
        if (std::holds_alternative<protocol::server::Welcome>(message)) {
            is_welcome_ = true;
            link_->keep_alive();
        }
        for (const auto& repeated : reconnect_.take_repeats()) link_->send(repeated);
        if (events_.push(Arrived{.message = std::move(message), .at = now})) link_->pause_reading();
    }

    void lost(const Lost& lost) {
        is_welcome_ = false;
        const std::optional<base::Duration> delay = reconnect_.lost(lost.code, local_now());
        events_.push(LinkLost{.lost = lost, .retry_after = delay});
        if (!delay) return;
        retry_.expires_after(*delay);
        retry_.async_wait([this](const asio::error_code& error) {
            if (!error) connect();
        });
    }

    ServerLinkOptions options_;
    Reconnect reconnect_;
    asio::io_context io_{1};
    asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
    asio::steady_timer retry_;
    std::optional<Link> link_;
    bool is_welcome_ = false;
    EventQueue events_;
    std::uint32_t last_request_id_ = 0;  ///< Of the caller's thread.
    std::thread thread_;
};

ServerLink::ServerLink(ServerLinkOptions options)
    : session_(std::make_unique<Session>(std::move(options))) {}

ServerLink::~ServerLink() = default;

std::uint32_t ServerLink::send(protocol::ClientMessageBody body) {
    return session_->send(std::move(body));
}

std::optional<LinkEvent> ServerLink::poll() {
    return session_->next(base::Duration::zero());
}

std::optional<LinkEvent> ServerLink::wait_for(base::Duration duration) {
    return session_->next(duration);
}

}  // namespace billiards::client
