// Takes seeds; gives whether the racks they make are the game's, and as random as they should be.
#include "common/rules/racking.h"

#include "common/model/rack.h"
#include "tests/common/rules/eight_ball_state.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace billiards::rules {
namespace {

constexpr double kRadius_m = model::BallSpec{}.radius_m;
constexpr std::size_t kMiddle = 4;
constexpr std::size_t kLeftCorner = 10;
constexpr std::size_t kRightCorner = 14;

model::Layout racked(std::uint64_t seed) {
    base::Random random(seed);
    const model::TableSpec& table = model::table_of(model::TableSize::NineFoot);
    return eight_ball().rack({}, table, kRadius_m, random);
}

model::BallId ball_at(const model::Layout& layout, std::size_t place) {
    const model::TableSpec& table = model::table_of(model::TableSize::NineFoot);
    const base::Vec2 wanted = model::triangle_positions(table, kRadius_m)[place];
    for (const model::PlacedBall& placed : layout.balls) {
        if (placed.place == model::Place::OnTable && placed.position_m == wanted) {
            return placed.ball;
        }
    }
    ADD_FAILURE() << "no ball at place " << place;
    return {};
}

bool is_solid(model::BallId ball) {
    return ball < model::kEightBall;
}

TEST(EightBallRack, HoldsEveryBallOnceInAscendingNumberAndTheCueBallInHand) {
    const model::Layout layout = racked(1);
    ASSERT_EQ(layout.balls.size(), 16U);
    for (std::size_t i = 0; i < layout.balls.size(); ++i) {
        EXPECT_EQ(layout.balls[i].ball.number, i);
        const auto expected = i == 0 ? model::Place::InHand : model::Place::OnTable;
        EXPECT_EQ(layout.balls[i].place, expected);
    }
    for (std::size_t place = 0; place < 15; ++place) ball_at(layout, place);
}

TEST(EightBallRack, HasTheEightInTheMiddleAndOneOfEachGroupAtTheRearCorners) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const model::Layout layout = racked(seed);
        EXPECT_EQ(ball_at(layout, kMiddle), model::kEightBall) << seed;
        EXPECT_NE(is_solid(ball_at(layout, kLeftCorner)), is_solid(ball_at(layout, kRightCorner)))
            << seed;
    }
}

TEST(EightBallRack, IsTheSameForTheSameSeedAndAnotherForAnother) {
    EXPECT_EQ(racked(7), racked(7));
    EXPECT_NE(racked(7), racked(8));
}

TEST(EightBallRack, PutsEveryBallAtEachCornerAndAtTheApexAboutEquallyOften) {
    constexpr int kRacks = 5600;
    constexpr double kExpected = kRacks / 14.0;
    for (const std::size_t place : {std::size_t{0}, kLeftCorner, kRightCorner}) {
        std::map<model::BallId, int> counts;
        for (std::uint64_t seed = 0; seed < kRacks; ++seed) ++counts[ball_at(racked(seed), place)];
        EXPECT_EQ(counts.size(), 14U);
        // Six standard deviations of a binomial count.
        for (const auto& [ball, count] : counts) {
            EXPECT_NEAR(count, kExpected, 6 * std::sqrt(kExpected)) << int{ball.number};
        }
    }
}

TEST(Shuffle, KeepsEveryBall) {
    std::vector<model::BallId> order{{3}, {1}, {4}, {5}, {9}};
    const std::vector<model::BallId> before = order;
    base::Random random(5);
    shuffle(order, random);
    EXPECT_TRUE(std::ranges::is_permutation(order, before));
}

}  // namespace
}  // namespace billiards::rules
