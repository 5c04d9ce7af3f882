// Takes the frames for one receiver; gives what to write next, and never holds more than a limit.
#include "server/net/write_queue.h"

#include <utility>

namespace billiards::server {

bool WriteQueue::push(const protocol::SharedFrame& frame, Delivery delivery) {
    if (delivery == Delivery::LatestWins) {
        drop_replaceable();
        if (bytes() + frame->size() > max_bytes_ / 2) return true;
        replaceable_ = waiting_.size();
    } else if (bytes() + frame->size() > max_bytes_) {
        return false;
    }
    waiting_bytes_ += frame->size();
    waiting_.push_back(frame);
    return true;
}

std::vector<protocol::SharedFrame> WriteQueue::take() {
    taken_bytes_ = std::exchange(waiting_bytes_, 0);
    replaceable_ = kNone;
    return std::exchange(waiting_, {});
}

void WriteQueue::drop_replaceable() {
    if (replaceable_ == kNone) return;
    const auto position = waiting_.begin() + static_cast<std::ptrdiff_t>(replaceable_);
    waiting_bytes_ -= (*position)->size();
    waiting_.erase(position);
    replaceable_ = kNone;
}

}  // namespace billiards::server
