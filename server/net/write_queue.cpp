// Takes the frames for one receiver; gives what to write next, and never holds more than a limit.
#include "server/net/write_queue.h"

#include <utility>

namespace billiards::server {

WriteQueue::Pushed WriteQueue::push(const protocol::SharedFrame& frame, Delivery delivery) {
    switch (delivery) {
        case Delivery::Ordered:
            if (bytes() + frame->size() > max_bytes_) return {.fits = false};
            add(frame, delivery);
            return {};
        case Delivery::LatestWins:
            push_latest(frame);
            return {};
        case Delivery::Sheddable:
            return {.shed = push_sheddable(frame)};
        case Delivery::Fresh:
            return push_fresh(frame);
    }
    return {};
}

/// With nothing on its way, any frame fits.
bool WriteQueue::is_over(std::size_t limit, std::size_t more_bytes) const {
    return bytes() > 0 && bytes() + more_bytes > limit;
}

void WriteQueue::add(const protocol::SharedFrame& frame, Delivery delivery) {
    waiting_bytes_ += frame->size();
    waiting_.push_back({frame, delivery});
}

void WriteQueue::push_latest(const protocol::SharedFrame& frame) {
    if (std::exchange(has_latest_, false)) {
        drop([](Delivery waiting) { return waiting == Delivery::LatestWins; });
    }
    if (is_behind() || bytes() + frame->size() > max_bytes_ / 2) return;
    add(frame, Delivery::LatestWins);
    has_latest_ = true;
}

std::size_t WriteQueue::push_sheddable(const protocol::SharedFrame& frame) {
    if (is_behind()) return 1;
    if (!is_over(max_sheddable_bytes_, frame->size())) {
        add(frame, Delivery::Sheddable);
        return 0;
    }
    following_ = Following::Behind;
    return shed() + 1;
}

WriteQueue::Pushed WriteQueue::push_fresh(const protocol::SharedFrame& frame) {
    const bool replaces = is_behind() || is_over(max_sheddable_bytes_, frame->size());
    const std::size_t dropped = replaces ? shed() : 0;
    if (is_over(max_bytes_, frame->size())) return {.fits = false, .shed = dropped};
    following_ = Following::Yes;
    add(frame, Delivery::Fresh);
    return {.shed = dropped};
}

std::vector<protocol::SharedFrame> WriteQueue::take() {
    taken_bytes_ = std::exchange(waiting_bytes_, 0);
    has_latest_ = false;
    std::vector<protocol::SharedFrame> frames;
    frames.reserve(waiting_.size());
    for (Waiting& waiting : std::exchange(waiting_, {})) frames.push_back(std::move(waiting.frame));
    return frames;
}

bool WriteQueue::tell_fell_behind() {
    if (following_ != Following::Behind) return false;
    following_ = Following::BehindAndTold;
    return true;
}

template <class Predicate>
std::size_t WriteQueue::drop(Predicate predicate) {
    return std::erase_if(waiting_, [&](const Waiting& waiting) {
        if (!predicate(waiting.delivery)) return false;
        waiting_bytes_ -= waiting.frame->size();
        return true;
    });
}

/// Everything that waits but what must arrive.
std::size_t WriteQueue::shed() {
    has_latest_ = false;
    return drop([](Delivery waiting) { return waiting != Delivery::Ordered; });
}

}  // namespace billiards::server
