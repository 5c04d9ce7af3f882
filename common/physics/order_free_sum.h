// Takes numbers; gives their sum to the same bits in whatever order they come.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace billiards::physics {

/// Floating-point sums depend on their order, and an order taken from ids or indices would let
/// names decide how balls part. Integer sums do not: each term is cut to a multiple of 2^-52 of the
/// largest. Negated terms give the negated sum. At most 512 terms.
inline double order_free_sum(std::span<const double> terms) {
    double largest = 0.0;
    for (const double term : terms) largest = std::max(largest, std::abs(term));
    if (largest == 0.0) return 0.0;
    const double scale = 0x1p52 / largest;
    std::int64_t sum = 0;
    for (const double term : terms) sum += static_cast<std::int64_t>(term * scale);
    return static_cast<double>(sum) * (largest * 0x1p-52);
}

}  // namespace billiards::physics
