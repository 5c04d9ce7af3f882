// Holds the numbers on the balls against what makes them readable.
#include "tools/make_assets/digits.h"

#include <gtest/gtest.h>

namespace billiards::make_assets {
namespace {

TEST(Lettering, StaysOnItsDisc) {
    // The disc is as wide as the digits are high: a radius of one in the lettering's units.
    for (int number = 1; number <= 15; ++number) {
        const Lettering digits = lettering(number);
        for (const auto& stroke : digits.strokes) {
            for (const base::Vec2& point : stroke) {
                EXPECT_LT(glm::length(point) + digits.pen, 0.95) << number;
            }
        }
    }
}

TEST(Lettering, InkIsWhereTheStrokesAre) {
    const Lettering one = lettering(1);
    EXPECT_LT(distance_to_ink(one, {0.03, 0.0}), 0.0);
    EXPECT_GT(distance_to_ink(one, {-0.2, -0.2}), 0.0);
    EXPECT_NEAR(distance_to_ink(one, {0.03 + one.pen + 0.1, 0.0}), 0.1, 1e-12);
}

TEST(Lettering, OnlySixAndNineAreUnderlined) {
    const base::Vec2 below{0.0, -0.68};
    for (int number = 1; number <= 15; ++number) {
        EXPECT_EQ(distance_to_ink(lettering(number), below) < 0, number == 6 || number == 9)
            << number;
    }
}

}  // namespace
}  // namespace billiards::make_assets
