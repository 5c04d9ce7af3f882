// Takes what the network tells the game; gives it to a test that waits for it.
#pragma once

#include "server/net/connection_events.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace billiards::server {

struct RecordedEvent {
    enum class Kind { Connected, Received, Malformed, FellBehind, Disconnected };
    Kind kind = Kind::Connected;
    SessionId session;
    std::optional<protocol::ClientMessage> message;
};

/// Any thread records, the test's thread waits; no wait is longer than five seconds.
class RecordedEvents final : public ConnectionEvents {
  public:
    using Kind = RecordedEvent::Kind;

    void connected(SessionId session, AddressKey /*from*/) override {
        record({Kind::Connected, session, {}});
    }
    void received(SessionId session, protocol::ClientMessage message) override {
        record({Kind::Received, session, std::move(message)});
    }
    void malformed(SessionId session, std::string) override {
        record({Kind::Malformed, session, {}});
    }
    void fell_behind(SessionId session) override { record({Kind::FellBehind, session, {}}); }
    void disconnected(SessionId session) override { record({Kind::Disconnected, session, {}}); }

    /// The count-th event of this kind, or none where it does not come in time.
    std::optional<RecordedEvent> wait_for(Kind kind, std::size_t count = 1) {
        std::unique_lock lock(mutex_);
        const bool came = changed_.wait_for(lock, std::chrono::seconds(5),
                                            [&] { return count_locked(kind) >= count; });
        if (!came) return std::nullopt;
        for (const RecordedEvent& event : events_) {
            if (event.kind == kind && --count == 0) return event;
        }
        return std::nullopt;
    }
    std::size_t count(Kind kind) {
        const std::lock_guard lock(mutex_);
        return count_locked(kind);
    }
    std::vector<RecordedEvent> all() {
        const std::lock_guard lock(mutex_);
        return events_;
    }

  private:
    void record(RecordedEvent event) {
        const std::lock_guard lock(mutex_);
        events_.push_back(std::move(event));
        changed_.notify_all();
    }
    std::size_t count_locked(Kind kind) const {
        return static_cast<std::size_t>(
            std::count_if(events_.begin(), events_.end(),
                          [&](const RecordedEvent& event) { return event.kind == kind; }));
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<RecordedEvent> events_;
};

}  // namespace billiards::server
