// Takes racks; gives whether their balls touch, stand on the foot spot and stay on the table.
#include "common/model/rack.h"

#include <gtest/gtest.h>

namespace billiards::model {
namespace {

using base::Vec2;

constexpr double kRadius_m = BallSpec{}.radius_m;

const TableSpec& nine_foot() {
    return table_of(TableSize::NineFoot);
}

/// How many pairs touch; none overlaps.
int touching_pairs(const std::vector<Vec2>& rack) {
    int touching = 0;
    for (std::size_t i = 0; i < rack.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double gap_m = glm::distance(rack[i], rack[j]) - 2 * kRadius_m;
            EXPECT_GT(gap_m, -1e-12);
            if (gap_m < 1e-12) ++touching;
        }
    }
    return touching;
}

TEST(Rack, TriangleOfTenIsFrozenWithItsApexOnTheFootSpot) {
    const std::vector<Vec2> rack = triangle_positions(nine_foot(), kRadius_m, 4);
    ASSERT_EQ(rack.size(), 10U);
    EXPECT_EQ(rack[0], foot_spot(nine_foot()));
    EXPECT_EQ(touching_pairs(rack), 18);
}

TEST(Rack, DiamondIsFrozenAndEndsInOneBall) {
    const std::vector<Vec2> rack = diamond_positions(nine_foot(), kRadius_m);
    ASSERT_EQ(rack.size(), 9U);
    EXPECT_EQ(rack[0], foot_spot(nine_foot()));
    EXPECT_EQ(rack[8].y, 0.0);
    EXPECT_EQ(touching_pairs(rack), 16);
}

TEST(Rack, MiddlePlaceTouchesSixBallsInEveryRack) {
    for (const std::vector<Vec2>& rack :
         {triangle_positions(nine_foot(), kRadius_m), triangle_positions(nine_foot(), kRadius_m, 4),
          diamond_positions(nine_foot(), kRadius_m)}) {
        int touching = 0;
        for (const Vec2& place : rack) {
            const double gap_m = glm::distance(place, rack[kMiddlePlace]) - 2 * kRadius_m;
            if (gap_m > -1e-12 && gap_m < 1e-12) ++touching;
        }
        EXPECT_EQ(touching, 6) << rack.size();
    }
}

TEST(Rack, DiamondMayStandWithItsMiddleOnTheFootSpotInstead) {
    const std::vector<Vec2> apex = diamond_positions(nine_foot(), kRadius_m);
    const std::vector<Vec2> middle = diamond_positions(nine_foot(), kRadius_m, OnFootSpot::Middle);
    EXPECT_EQ(middle[kMiddlePlace], foot_spot(nine_foot()));
    const Vec2 moved = middle[0] - apex[0];
    EXPECT_LT(moved.x, 0.0);
    for (std::size_t place = 0; place < apex.size(); ++place) {
        EXPECT_NEAR(glm::distance(apex[place] + moved, middle[place]), 0.0, 1e-12);
    }
}

}  // namespace
}  // namespace billiards::model
