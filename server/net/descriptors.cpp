// Takes the system's limit; gives what is left of it for connections.
#include "server/net/descriptors.h"

#include "common/base/check.h"

#include <algorithm>
#include <sys/resource.h>

namespace billiards::server {

std::size_t descriptors_allowed() {
    rlimit limit{};
    CHECK(::getrlimit(RLIMIT_NOFILE, &limit) == 0);
    return limit.rlim_cur;
}

std::size_t connections_within(std::size_t wanted, std::size_t descriptors, std::size_t reserve) {
    return std::min(wanted, descriptors - std::min(reserve, descriptors / 2));
}

}  // namespace billiards::server
