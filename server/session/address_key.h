// Gives what counts as one address in every limit that holds for one.
#pragma once

#include <cstdint>
#include <optional>

namespace billiards::server {

/// None for this machine's own, which no such limit holds for.
using AddressKey = std::optional<std::uint64_t>;

}  // namespace billiards::server
