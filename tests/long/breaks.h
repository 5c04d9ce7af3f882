// Takes a number of shots; gives whether every invariant held over all of them.
#pragma once

#include <cstdint>
#include <ostream>

namespace billiards {

struct BreaksOrder {
    std::uint64_t shots = 100'000;
    std::uint64_t first = 0;
};

/// Solves the shots numbered first, first + 1, ... (numbered_case.h). Writes every fault with the
/// number of its shot, and the figures at the end.
bool prove_breaks(const BreaksOrder& order, std::ostream& out);

}  // namespace billiards
