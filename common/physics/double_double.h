// Takes doubles; gives sums and products to twice their digits, by + - * alone.
#pragma once

namespace billiards::physics {

/// high + low, |low| at most half a unit in the last place of high: about 32 digits. Not for
/// numbers near the ends of the range. (Dekker, "A floating-point technique for extending the
/// available precision", 1971; Knuth's sum of two.)
struct DoubleDouble {
    double high = 0.0;
    double low = 0.0;
};

inline DoubleDouble exact_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

inline DoubleDouble exact_product(double a, double b) {
    constexpr double kSplitter = 134217729.0;  // 2^27 + 1: halves of 26 digits.
    const double a_scaled = kSplitter * a;
    const double b_scaled = kSplitter * b;
    const double a_high = a_scaled - (a_scaled - a);
    const double b_high = b_scaled - (b_scaled - b);
    const double a_low = a - a_high;
    const double b_low = b - b_high;
    const double product = a * b;
    return {product,
            ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = exact_sum(a.high, b.high);
    const DoubleDouble low = exact_sum(a.low, b.low);
    const DoubleDouble sum = exact_sum(high.high, high.low + low.high);
    return exact_sum(sum.high, sum.low + low.low);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble product = exact_product(a.high, b.high);
    return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

}  // namespace billiards::physics
