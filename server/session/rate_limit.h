// Takes moments; says whether one more is within a rate.
#pragma once

#include "common/base/check.h"
#include "common/base/time.h"

#include <algorithm>

namespace billiards::server {

/// `burst` at once, then one an interval (the generic cell rate algorithm, ITU-T I.371). Eight
/// bytes of state a limit.
class RateLimit {
  public:
    RateLimit(int count, base::Duration per, int burst)
        : interval_(per / (CHECK(count > 0), count)), tolerance_(interval_ * (burst - 1)) {
        CHECK(burst > 0);
    }
    /// All of a period's count may come at once.
    RateLimit(int count, base::Duration per) : RateLimit(count, per, count) {}

    /// Whether one more would be within the rate; it is not counted.
    bool has_room(base::Instant now) const { return now + tolerance_ >= expected_; }

    /// Counts this one, if it may pass.
    bool allows(base::Instant now) {
        if (!has_room(now)) return false;
        expected_ = std::max(expected_, now) + interval_;
        return true;
    }

  private:
    base::Duration interval_;
    base::Duration tolerance_;
    base::Instant expected_ = base::Instant::min();  ///< Of the next one, were they evenly spread.
};

}  // namespace billiards::server
