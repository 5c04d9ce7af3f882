// Holds the first descent of a polynomial against polynomials made from known roots.
#include "common/physics/roots.h"

#include "common/physics/motion.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <vector>

namespace billiards::physics {
namespace {

/// sign * (t - r1) (t - r2) ...
Polynomial with_roots(double sign, const std::vector<double>& roots) {
    Polynomial p{{sign, 0, 0, 0, 0}};
    for (const double root : roots) {
        for (std::size_t k = 4; k > 0; --k) p.c[k] = p.c[k - 1] - root * p.c[k];
        p.c[0] *= -root;
    }
    return p;
}

TEST(Roots, FindsTheFirstDescentOfEachDegree) {
    EXPECT_DOUBLE_EQ(first_descent(with_roots(-1, {2.0}), 10.0), 2.0);
    EXPECT_DOUBLE_EQ(first_descent(with_roots(1, {2.0, 5.0}), 10.0), 2.0);
    EXPECT_DOUBLE_EQ(first_descent(with_roots(-1, {2.0, 5.0}), 10.0), 5.0);
    EXPECT_DOUBLE_EQ(first_descent(with_roots(1, {1.0, 2.0, 5.0}), 10.0), 2.0);
    EXPECT_DOUBLE_EQ(first_descent(with_roots(1, {1.0, 2.0, 3.0, 5.0}), 10.0), 1.0);
    EXPECT_DOUBLE_EQ(first_descent(with_roots(-1, {1.0, 2.0, 3.0, 5.0}), 10.0), 2.0);
}

TEST(Roots, FindsNothingWhereNothingFalls) {
    EXPECT_EQ(first_descent({{1, 0, 0, 0, 0}}, 10.0), kNever_s);
    EXPECT_EQ(first_descent({{0, 0, 0, 0, 0}}, 10.0), kNever_s);
    EXPECT_EQ(first_descent({{-1, 0, 0, 0, 0}}, 10.0), kNever_s);
    EXPECT_EQ(first_descent({{-1, -1, -1, 0, 0}}, 10.0), kNever_s) << "it was never above";
    EXPECT_EQ(first_descent(with_roots(1, {2.0, 5.0}), 1.9), kNever_s) << "beyond the horizon";
}

TEST(Roots, StartsAtZeroOnlyByRisingFirst) {
    EXPECT_EQ(first_descent({{0, -1, 0, 0, 0}}, 10.0), kNever_s);
    EXPECT_DOUBLE_EQ(first_descent({{0, 1, -1, 0, 0}}, 10.0), 1.0);
}

TEST(Roots, LooksForEverWhereTheHorizonIsOpen) {
    EXPECT_NEAR(first_descent(with_roots(1, {1e5, 2e5}), kNever_s), 1e5, 1e-9);
    EXPECT_EQ(first_descent({{1, 2, 3, 4, 5}}, kNever_s), kNever_s);
}

RC_GTEST_PROP(Roots, AreFoundWhereverFourOfThemLie, ()) {
    std::vector<double> roots;
    for (int i = 0; i < 4; ++i) roots.push_back(*rc::gen::inRange(1, 4000) / 1000.0);
    std::sort(roots.begin(), roots.end());
    for (std::size_t i = 1; i < 4; ++i) RC_PRE(roots[i] - roots[i - 1] > 0.05);
    const double found = first_descent(with_roots(1, roots), 5.0);
    RC_ASSERT(std::abs(found - roots[0]) < 1e-11);
}

}  // namespace
}  // namespace billiards::physics
