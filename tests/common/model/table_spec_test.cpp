// Holds the three tables against the numbers of the WPA equipment specification.
#include "common/model/table_spec.h"

#include "common/base/elementary.h"
#include "common/model/rack.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace billiards::model {
namespace {

using base::Vec2;

constexpr double kInch_m = 0.0254;

struct NamedSize {
    TableSize size;
    Vec2 playing_m;
};

class Tables : public ::testing::TestWithParam<NamedSize> {
  protected:
    const TableSpec& table() const { return table_of(GetParam().size); }
};

INSTANTIATE_TEST_SUITE_P(All, Tables,
                         ::testing::Values(NamedSize{TableSize::SevenFoot, {1.98, 0.99}},
                                           NamedSize{TableSize::EightFoot, {2.24, 1.12}},
                                           NamedSize{TableSize::NineFoot, {2.54, 1.27}}));

double distance_to_line(Vec2 point, const CushionSegment& line) {
    const Vec2 along = glm::normalize(line.to_m - line.from_m);
    const Vec2 offset = point - line.from_m;
    return std::fabs(along.x * offset.y - along.y * offset.x);
}

TEST_P(Tables, NosesLieOnThePlayingSurfaceEdge) {
    for (std::size_t i = 0; i < 6; ++i) {
        const CushionSegment& nose = table().cushions[i];
        const bool is_end = i == 2 || i == 5;
        const double expected = (is_end ? GetParam().playing_m.x : GetParam().playing_m.y) / 2;
        EXPECT_NEAR(std::fabs(is_end ? nose.from_m.x : nose.from_m.y), expected, 1e-15);
        EXPECT_NEAR(std::fabs(is_end ? nose.to_m.x : nose.to_m.y), expected, 1e-15);
    }
}

TEST_P(Tables, FacingsTurnAwayAt142DegreesAtCornersAnd104AtSides) {
    for (std::size_t rail = 0; rail < 6; ++rail) {
        const CushionSegment& nose = table().cushions[rail];
        const Vec2 along = glm::normalize(nose.to_m - nose.from_m);
        for (std::size_t end = 0; end < 2; ++end) {
            const CushionSegment& facing = table().cushions[6 + 2 * rail + end];
            const Vec2 outward = end == 0 ? -along : along;
            const double cosine = glm::dot(glm::normalize(facing.to_m - facing.from_m), outward);
            const std::size_t pocket = (rail + end) % 6;
            const double interior = pocket == 1 || pocket == 4 ? 104.0 : 142.0;
            EXPECT_NEAR(cosine, std::cos(base::radians(180.0 - interior)), 1e-12);
        }
    }
}

TEST_P(Tables, EveryJawTouchesItsNoseAndItsFacingTangentially) {
    for (std::size_t i = 0; i < 12; ++i) {
        const JawArc& jaw = table().jaws[i];
        EXPECT_NEAR(distance_to_line(jaw.center_m, table().cushions[i / 2]), jaw.radius_m, 1e-12);
        EXPECT_NEAR(distance_to_line(jaw.center_m, table().cushions[6 + i]), jaw.radius_m, 1e-12);
        const CushionSegment& nose = table().cushions[i / 2];
        const Vec2 end = i % 2 == 0 ? nose.from_m : nose.to_m;
        EXPECT_NEAR(glm::length(jaw.center_m - end), jaw.radius_m, 1e-6);
        EXPECT_NEAR(glm::length(jaw.center_m - table().cushions[6 + i].from_m), jaw.radius_m, 1e-6);
    }
}

TEST_P(Tables, MouthsHaveTheSpecifiedWidth) {
    const auto mouth = [&](std::size_t pocket) {
        const JawArc& before = table().jaws[2 * ((pocket + 5) % 6) + 1];
        const JawArc& after = table().jaws[2 * pocket];
        return glm::length(before.center_m - after.center_m) - 2 * before.radius_m;
    };
    for (const std::size_t corner : {0U, 2U, 3U, 5U}) {
        EXPECT_GE(mouth(corner), 4.5 * kInch_m - 0.005) << corner;
        EXPECT_LE(mouth(corner), 4.625 * kInch_m) << corner;
    }
    for (const std::size_t side : {1U, 4U}) {
        EXPECT_GE(mouth(side), 5.0 * kInch_m - 0.005) << side;
        EXPECT_LE(mouth(side), 5.125 * kInch_m) << side;
    }
}

TEST_P(Tables, PocketsAreNumberedAnticlockwiseFromTheHeadsLowerCorner) {
    const std::vector<PocketCircle>& pockets = table().pockets;
    ASSERT_EQ(pockets.size(), 6U);
    const Vec2 signs[] = {{-1, -1}, {0, -1}, {1, -1}, {1, 1}, {0, 1}, {-1, 1}};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(glm::sign(pockets[i].center_m), signs[i]) << i;
    }
}

TEST_P(Tables, NoRestingBallIsInAPocketAndEveryBallThatPassesTheFacingsIs) {
    const double radius = BallSpec{}.radius_m;
    for (std::size_t i = 0; i < 6; ++i) {
        const PocketCircle& pocket = table().pockets[i];
        const Vec2 corner = glm::sign(pocket.center_m) * (table().half_playing_m - radius);
        EXPECT_GT(glm::length(pocket.center_m - corner), pocket.radius_m) << i;
        const Vec2 gate =
            (table().cushions[6 + 2 * i].to_m + table().cushions[6 + 2 * ((i + 5) % 6) + 1].to_m) /
            2.0;
        EXPECT_LT(glm::length(pocket.center_m - gate), pocket.radius_m - radius) << i;
    }
}

TEST_P(Tables, HalfATurnGivesTheSameTableToTheBit) {
    const TableSpec& spec = table();
    for (std::size_t rail = 0; rail < 3; ++rail) {
        EXPECT_EQ(spec.cushions[rail + 3].from_m, -spec.cushions[rail].from_m);
        EXPECT_EQ(spec.cushions[rail + 3].to_m, -spec.cushions[rail].to_m);
        EXPECT_EQ(spec.pockets[rail + 3].center_m, -spec.pockets[rail].center_m);
    }
}

TEST_P(Tables, TheRackIsFrozenOnTheFootSpotAndInsideTheTable) {
    const double radius = BallSpec{}.radius_m;
    const std::vector<Vec2> rack = triangle_positions(table(), radius);
    ASSERT_EQ(rack.size(), 15U);
    EXPECT_EQ(rack[0], foot_spot(table()));
    int touching = 0;
    for (std::size_t i = 0; i < rack.size(); ++i) {
        EXPECT_LT(rack[i].x, table().half_playing_m.x - radius);
        for (std::size_t j = 0; j < i; ++j) {
            const double gap = glm::length(rack[i] - rack[j]) - 2 * radius;
            EXPECT_GT(gap, -1e-12);
            if (gap < 1e-12) ++touching;
        }
    }
    EXPECT_EQ(touching, 30);
}

}  // namespace
}  // namespace billiards::model
