// Takes how many descriptors the system gives this process; gives how many connections fit in.
#pragma once

#include <cstddef>

namespace billiards::server {

/// What this process may have open at once now: files, sockets and all.
std::size_t descriptors_allowed();

/// The connections that are wanted, or as many as leave `reserve` of the descriptors free for
/// files, logs and status pages; where there are less than twice as many as that, half of them.
std::size_t connections_within(std::size_t wanted, std::size_t descriptors, std::size_t reserve);

}  // namespace billiards::server
