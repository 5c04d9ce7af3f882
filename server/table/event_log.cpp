// Takes numbered frames; keeps the newest within two limits.
#include "server/table/event_log.h"

#include <utility>

namespace billiards::server {

void EventLog::skip_to(std::uint64_t sequence) {
    last_ = sequence;
    frames_.clear();
    bytes_ = 0;
}

void EventLog::append(protocol::SharedFrame frame) {
    ++last_;
    bytes_ += frame->size();
    frames_.push_back(std::move(frame));
    while (frames_.size() > limits_.events || bytes_ > limits_.bytes) {
        bytes_ -= frames_.front()->size();
        frames_.pop_front();
    }
}

std::optional<std::vector<protocol::SharedFrame>> EventLog::since(std::uint64_t sequence) const {
    if (sequence > last_ || last_ - sequence > frames_.size()) return std::nullopt;
    const auto missed = static_cast<std::ptrdiff_t>(last_ - sequence);
    return std::vector(frames_.end() - missed, frames_.end());
}

}  // namespace billiards::server
