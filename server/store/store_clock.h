// Gives the two clocks that a store reads: one to show, one to measure with.
#pragma once

#include <cstdint>
#include <functional>

namespace billiards::server {

struct StoreTimes {
    std::int64_t calendar_s = 0;  ///< Since 1970-01-01 UTC; may jump.
    std::int64_t steady_s = 0;    ///< Since the machine started; only runs on.
};

using StoreClock = std::function<StoreTimes()>;

StoreTimes system_times();

}  // namespace billiards::server
