// Gives the client's own monotonic clock, which only the network and the programs read.
#pragma once

#include "common/base/time.h"

#include <chrono>

namespace billiards::client {

inline base::Instant local_now() {
    return base::Instant(std::chrono::duration_cast<base::Duration>(
        std::chrono::steady_clock::now().time_since_epoch()));
}

}  // namespace billiards::client
