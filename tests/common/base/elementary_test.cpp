// Holds the elementary functions against libm in long double.
#include "common/base/elementary.h"

#include "common/base/random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace billiards::base {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Elementary, SineAndCosineAreGoodTo1e15OverAThousandRadians) {
    Random random(1);
    for (int i = 0; i < 20'000; ++i) {
        const double x = random.uniform(-1000, 1000);
        EXPECT_NEAR(sine(x), static_cast<double>(std::sin(static_cast<long double>(x))), 1e-15)
            << x;
        EXPECT_NEAR(cosine(x), static_cast<double>(std::cos(static_cast<long double>(x))), 1e-15)
            << x;
    }
}

TEST(Elementary, ArcTangentIsGoodTo1e15InEveryQuadrant) {
    Random random(2);
    for (int i = 0; i < 20'000; ++i) {
        const double y = random.uniform(-3, 3);
        const double x = random.uniform(-3, 3);
        EXPECT_NEAR(arc_tangent(y, x),
                    static_cast<double>(std::atan2(static_cast<long double>(y), x)), 1e-15)
            << y << ' ' << x;
    }
}

TEST(Elementary, ArcTangentKeepsTheAxes) {
    EXPECT_EQ(arc_tangent(0, 0), 0);
    EXPECT_EQ(arc_tangent(0, 1), 0);
    EXPECT_EQ(arc_tangent(0, -1), kPi);
    EXPECT_EQ(arc_tangent(1, 0), kPi / 2);
    EXPECT_EQ(arc_tangent(-1, 0), -kPi / 2);
}

TEST(Elementary, ArcSineIsGoodTo1e15) {
    for (double x = -1; x <= 1; x += 1.0 / 512) EXPECT_NEAR(arc_sine(x), std::asin(x), 1e-15) << x;
}

TEST(Elementary, ExponentialIsGoodTo1e15Relatively) {
    Random random(3);
    for (int i = 0; i < 20'000; ++i) {
        const double x = random.uniform(-700, 700);
        const double truth = static_cast<double>(std::exp(static_cast<long double>(x)));
        EXPECT_NEAR(exponential(x) / truth, 1.0, 1e-15) << x;
    }
}

TEST(Elementary, ValuesWithoutMeaningGiveNaNAndNeverHang) {
    EXPECT_TRUE(std::isnan(sine(kInfinity)));
    EXPECT_TRUE(std::isnan(cosine(-kInfinity)));
    EXPECT_TRUE(std::isnan(exponential(std::nan(""))));
    EXPECT_TRUE(std::isnan(arc_tangent(std::nan(""), 1)));
    EXPECT_LE(std::fabs(sine(1e300)), 1.0);
    EXPECT_EQ(exponential(-1e300), 0.0);
    EXPECT_EQ(exponential(1e300), kInfinity);
}

}  // namespace
}  // namespace billiards::base
