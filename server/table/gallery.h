// Takes what happens at a table and how late its spectators are to see it; gives the frames whose
// time has come, and the table as it was then.
#pragma once

#include "common/base/time.h"
#include "common/protocol/codec.h"
#include "common/protocol/messages.h"
#include "server/session/limits.h"
#include "server/table/event_log.h"
#include "server/table/outbox.h"
#include "server/table/picture.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace billiards::server {

/// What waits takes about so much beside its frame: an event with the table after it, and a remark.
inline constexpr std::size_t kWaitingEventBytes = 4096;
inline constexpr std::size_t kWaitingRemarkBytes = 512;

/// Without a delay it holds nothing, and spectators get the players' frames. With one it tells them
/// everything later and in the same order, encoded once for all of them, in a stream of its own.
class Gallery {
  public:
    explicit Gallery(const LobbyLimits& limits);

    /// Whether spectators are shown what the gallery shows, not what the players see.
    bool is_delayed() const { return is_delayed_; }
    /// Nothing waits to be shown.
    bool is_drained() const { return queue_.empty(); }

    /// From the next event on. Where it was live, `shown` is what spectators have seen so far, and
    /// `stream` numbers what they will. What waits already is shown when it would have been; once
    /// all of that is, a gallery without a delay is live.
    void set_delay(base::Duration delay, const Picture& shown, std::uint64_t stream);

    /// Something that has a number, and the table after it.
    void add(base::Instant now, protocol::SharedFrame event, Picture after);
    /// Something that has none: dropped while the gallery is full.
    void add(base::Instant now, protocol::SharedFrame remark, Delivery delivery);
    /// What is shown until something else is due, where nobody knows any more what was.
    void begin_with(Picture shown) { shown_ = std::move(shown); }
    /// The table as it is, without what led to it.
    void jump(base::Instant now, Picture to);

    std::optional<base::Instant> next_deadline() const;
    struct News {
        protocol::SharedFrame frame;
        Delivery delivery = Delivery::Sheddable;
    };
    /// What is to be shown by now, in its order.
    std::vector<News> take_due(base::Instant now);

    const Picture& shown() const { return shown_; }
    /// The table as spectators see it, its moments moved.
    protocol::server::TableRow row() const;
    protocol::server::TableSnapshot snapshot(base::Instant now) const;
    std::uint64_t stream() const { return stream_; }
    const EventLog& log() const { return log_; }

  private:
    struct Item {
        base::Instant due;
        base::Duration late{};
        protocol::SharedFrame frame;  ///< As the players got it; none: a jump.
        std::size_t bytes = 0;
        Delivery delivery = Delivery::Sheddable;
        std::optional<Picture> after;
    };

    bool is_full(std::size_t more_bytes) const;
    void push(base::Instant now, Item item);
    News show(base::Instant now, Item item);

    std::size_t most_events_;
    std::size_t most_bytes_;
    bool is_delayed_ = false;
    base::Duration delay_{};
    std::deque<Item> queue_;
    std::size_t bytes_ = 0;  ///< Of what waits; of its frames, as the players got them.
    base::Instant last_due_ = base::Instant::min();

    Picture shown_;
    base::Duration late_{};  ///< How old what is shown is.
    std::uint64_t stream_ = 0;
    EventLog log_;
};

}  // namespace billiards::server
