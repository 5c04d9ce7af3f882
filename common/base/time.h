// Gives the time that is passed as an argument; reading a clock is for `main`, `net` and `app`.
#pragma once

#include <chrono>

namespace billiards::base {

/// A clock's name without a clock: it cannot be asked what time it is, only told.
struct MonotonicClock {
    using duration = std::chrono::microseconds;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<MonotonicClock>;
    static constexpr bool is_steady = true;
};

using Duration = MonotonicClock::duration;
/// A moment on the server's monotonic clock, in microseconds since the server started.
using Instant = MonotonicClock::time_point;

inline double seconds(Duration duration) {
    return std::chrono::duration<double>(duration).count();
}
inline Duration duration_of(double length_s) {
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(length_s));
}

}  // namespace billiards::base
