// Takes doubles; gives elementary functions as argument reduction and Taylor series, in an order
// of operations that is written down, so that no compiler or processor can change a bit.
#include "common/base/elementary.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace billiards::base {

namespace {

// pi/2 and ln 2 in parts: the leading ones have trailing zero bits, so that k times them is exact
// for the k that occur (Cody and Waite, "Software Manual for the Elementary Functions", 1980).
constexpr double kHalfPiHigh = 0x1.921fb54400000p+0;
constexpr double kHalfPiMiddle = 0x1.0b4611a600000p-34;
constexpr double kHalfPiLow = 0x1.3198a2e037073p-69;
constexpr double kLn2High = 0x1.62e42fee00000p-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

struct Reduced {
    double remainder;   // In [-pi/4, pi/4].
    unsigned quadrant;  // 0 - 3.
};

Reduced reduce(double angle_rad) {
    // Beyond the exact range an angle has no meaning to 1e-15 anyway; fmod is exact by IEEE 754.
    if (std::fabs(angle_rad) > 1e6) angle_rad = std::fmod(angle_rad, 4 * kHalfPiHigh);
    const double turns = std::floor(angle_rad / kHalfPiHigh + 0.5);
    const double remainder =
        ((angle_rad - turns * kHalfPiHigh) - turns * kHalfPiMiddle) - turns * kHalfPiLow;
    return {remainder, static_cast<unsigned>(static_cast<std::int64_t>(turns) & 3)};
}

// Taylor about 0; on [-pi/4, pi/4] the first term left out is below 1e-19.
double sine_series(double x) {
    const double square = x * x;
    double term_factor = 1.0;
    for (int n = 8; n >= 1; --n) term_factor = 1.0 - square / (2 * n * (2 * n + 1)) * term_factor;
    return x * term_factor;
}

double cosine_series(double x) {
    const double square = x * x;
    double sum = 1.0;
    for (int n = 8; n >= 1; --n) sum = 1.0 - square / ((2 * n - 1) * (2 * n)) * sum;
    return sum;
}

// For |x| <= tan(pi/16) = 0.199; the first term left out is below 1e-19.
double arc_tangent_series(double x) {
    const double square = x * x;
    double sum = 0.0;
    for (int n = 12; n >= 0; --n) sum = 1.0 / (2 * n + 1) - square * sum;
    return x * sum;
}

// For 0 <= x <= 1: halve the angle twice, atan x = 2 atan(x / (1 + sqrt(1 + x^2))).
double arc_tangent_of_unit(double x) {
    const double half = x / (1.0 + std::sqrt(1.0 + x * x));
    const double quarter = half / (1.0 + std::sqrt(1.0 + half * half));
    return 4.0 * arc_tangent_series(quarter);
}

}  // namespace

double sine(double angle_rad) {
    if (!std::isfinite(angle_rad)) return std::numeric_limits<double>::quiet_NaN();
    const Reduced reduced = reduce(angle_rad);
    const double value = (reduced.quadrant & 1U) != 0 ? cosine_series(reduced.remainder)
                                                      : sine_series(reduced.remainder);
    return (reduced.quadrant & 2U) != 0 ? -value : value;
}

double cosine(double angle_rad) {
    if (!std::isfinite(angle_rad)) return std::numeric_limits<double>::quiet_NaN();
    const Reduced reduced = reduce(angle_rad);
    const double value = (reduced.quadrant & 1U) != 0 ? -sine_series(reduced.remainder)
                                                      : cosine_series(reduced.remainder);
    return (reduced.quadrant & 2U) != 0 ? -value : value;
}

double arc_tangent(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
    const double width = std::fabs(x);
    const double height = std::fabs(y);
    if (width == 0.0 && height == 0.0) return 0.0;
    // In the first octant the quotient is at most 1; the others follow by symmetry.
    const double octant = height <= width ? arc_tangent_of_unit(height / width)
                                          : kPi / 2 - arc_tangent_of_unit(width / height);
    const double half_plane = x < 0 ? kPi - octant : octant;
    return y < 0 ? -half_plane : half_plane;
}

double arc_sine(double x) {
    return arc_tangent(x, std::sqrt((1.0 - x) * (1.0 + x)));
}

double exponential(double x) {
    if (std::isnan(x)) return x;
    if (x > 709.7) return std::numeric_limits<double>::infinity();
    if (x < -745.0) return 0.0;
    const double power = std::floor(x / (kLn2High + kLn2Low) + 0.5);
    const double rest = (x - power * kLn2High) - power * kLn2Low;
    double sum = 1.0;
    for (int n = 14; n >= 1; --n) sum = 1.0 + rest / n * sum;
    // In two steps, because 2^power alone may lie below the smallest normal number.
    const auto scale = [](std::int64_t exponent) {
        return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
    };
    const auto exponent = static_cast<std::int64_t>(power);
    return sum * scale(exponent / 2) * scale(exponent - exponent / 2);
}

}  // namespace billiards::base
