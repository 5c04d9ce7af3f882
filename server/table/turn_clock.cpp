// Takes moments; keeps one turn's opening and deadline.
#include "server/table/turn_clock.h"

#include "common/base/check.h"

#include <algorithm>

namespace billiards::server {

void TurnClock::wait_until(base::Instant opens, std::optional<base::Duration> allowed) {
    stage_ = Stage::Waiting;
    opens_ = opens;
    left_ = allowed;
    deadline_.reset();
}

void TurnClock::open(base::Instant now) {
    CHECK(is_waiting());
    open(now, left_);
}

void TurnClock::open(base::Instant now, std::optional<base::Duration> allowed) {
    stage_ = Stage::Open;
    opens_ = now;
    left_ = allowed;
    deadline_.reset();
    if (running_ && left_) deadline_ = now + *left_;
}

void TurnClock::extend(base::Duration by) {
    CHECK(is_open() && left_.has_value());
    *left_ += by;
    if (deadline_) *deadline_ += by;
}

void TurnClock::stop() {
    stage_ = Stage::None;
    left_.reset();
    deadline_.reset();
}

bool TurnClock::set_running(base::Instant now, bool running) {
    if (running_ == running) return false;
    running_ = running;
    if (!is_open() || !left_) return false;
    if (running) {
        deadline_ = now + *left_;
    } else {
        left_ = std::max(*deadline_ - now, base::Duration::zero());
        deadline_.reset();
    }
    return true;
}

protocol::server::Turn TurnClock::view() const {
    protocol::server::Turn turn{.opens_us = wire_time(opens_), .deadline_us = {}};
    if (deadline_) turn.deadline_us = wire_time(*deadline_);
    return turn;
}

std::int64_t wire_time(base::Instant instant) {
    return instant.time_since_epoch().count();
}

}  // namespace billiards::server
