// Takes the frames for one receiver; gives what to write next, and never holds more than a limit.
#pragma once

#include "common/protocol/codec.h"
#include "server/table/outbox.h"

#include <cstddef>
#include <vector>

namespace billiards::server {

/// Holds shares of frames. An empty queue owns no memory, since most receivers wait for nothing.
class WriteQueue {
  public:
    explicit WriteQueue(std::size_t max_bytes) : max_bytes_(max_bytes) {}

    /// False: an ordered frame no longer fits. A frame of which the latest wins takes the place of
    /// the one that waits, and is dropped where the queue is half full.
    bool push(const protocol::SharedFrame& frame, Delivery delivery);
    /// Everything that waits, in order; until the next call of written() it still counts.
    std::vector<protocol::SharedFrame> take();
    /// What was taken is out.
    void written() { taken_bytes_ = 0; }

    bool nothing_waits() const { return waiting_.empty(); }
    std::size_t bytes() const { return waiting_bytes_ + taken_bytes_; }

  private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    void drop_replaceable();

    std::size_t max_bytes_;
    std::vector<protocol::SharedFrame> waiting_;
    std::size_t replaceable_ = kNone;  ///< Where in waiting_ the one is that a newer one replaces.
    std::size_t waiting_bytes_ = 0;
    std::size_t taken_bytes_ = 0;
};

}  // namespace billiards::server
