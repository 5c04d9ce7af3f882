// Gives the two clocks that a store reads: one to show, one to measure with.
#include "server/store/store_clock.h"

#include <chrono>

namespace billiards::server {

StoreTimes system_times() {
    using std::chrono::duration_cast;
    using std::chrono::seconds;
    const auto calendar = std::chrono::system_clock::now().time_since_epoch();
    const auto steady = std::chrono::steady_clock::now().time_since_epoch();
    return {.calendar_s = duration_cast<seconds>(calendar).count(),
            .steady_s = duration_cast<seconds>(steady).count()};
}

}  // namespace billiards::server
