// Takes the frames for one receiver; gives what to write next, and never holds more than a limit.
#pragma once

#include "common/protocol/codec.h"
#include "server/table/outbox.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace billiards::server {

/// Holds shares of frames. An empty queue owns no memory, since most receivers wait for nothing.
///
/// A receiver falls behind when a frame that can be shed does not fit below its own, smaller limit:
/// then all of that kind is dropped, and whatever more of it comes, until a fresh one.
class WriteQueue {
  public:
    /// `max_sheddable_bytes` is no larger than `max_bytes`. A single frame may be larger than it.
    WriteQueue(std::size_t max_bytes, std::size_t max_sheddable_bytes)
        : max_bytes_(max_bytes), max_sheddable_bytes_(max_sheddable_bytes) {}

    struct Pushed {
        bool fits = true;      ///< False: an ordered frame is beyond the limit.
        std::size_t shed = 0;  ///< Frames that this receiver will not get now.
    };
    /// A frame of which the latest wins takes the place of the one that waits, and is dropped where
    /// the queue is half full or the receiver behind. A fresh one is taken in place of everything
    /// that can be shed, where that does not fit any more.
    Pushed push(const protocol::SharedFrame& frame, Delivery delivery);
    /// Everything that waits, in order; until the next call of written() it still counts.
    std::vector<protocol::SharedFrame> take();
    /// What was taken is out.
    void written() { taken_bytes_ = 0; }
    /// True once for each time that the receiver has fallen behind, unless a fresh frame came
    /// first.
    bool tell_fell_behind();

    bool nothing_waits() const { return waiting_.empty(); }
    std::size_t bytes() const { return waiting_bytes_ + taken_bytes_; }

  private:
    enum class Following : std::uint8_t { Yes, Behind, BehindAndTold };
    struct Waiting {
        protocol::SharedFrame frame;
        Delivery delivery = Delivery::Ordered;
    };

    bool is_behind() const { return following_ != Following::Yes; }
    bool is_over(std::size_t limit, std::size_t more_bytes) const;
    void add(const protocol::SharedFrame& frame, Delivery delivery);
    void push_latest(const protocol::SharedFrame& frame);
    std::size_t push_sheddable(const protocol::SharedFrame& frame);
    Pushed push_fresh(const protocol::SharedFrame& frame);
    template <class Predicate>
    std::size_t drop(Predicate predicate);
    std::size_t shed();

    std::size_t max_bytes_;
    std::size_t max_sheddable_bytes_;
    std::vector<Waiting> waiting_;
    std::size_t waiting_bytes_ = 0;
    std::size_t taken_bytes_ = 0;
    bool has_latest_ = false;  ///< Among what waits: a frame that a newer one replaces.
    Following following_ = Following::Yes;
};

}  // namespace billiards::server
