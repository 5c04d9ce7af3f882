// Shows that a set of balls is a set.
#include "common/model/ball.h"

#include <gtest/gtest.h>
#include <vector>

namespace billiards::model {
namespace {

TEST(BallSet, VisitsItsBallsInAscendingNumber) {
    const BallSet set{BallId{9}, BallId{1}, BallId{15}};
    std::vector<int> visited;
    set.for_each([&](BallId ball) { visited.push_back(ball.number); });
    EXPECT_EQ(visited, (std::vector<int>{1, 9, 15}));
    EXPECT_EQ(set.size(), 3);
}

TEST(BallSet, CombinesLikeSets) {
    const BallSet a{BallId{1}, BallId{2}};
    const BallSet b{BallId{2}, BallId{3}};
    EXPECT_EQ(a & b, BallSet{BallId{2}});
    EXPECT_EQ((a | b).size(), 3);
    EXPECT_EQ(a - b, BallSet{BallId{1}});
}

TEST(BallSet, DropsBitsThatNoBallHas) {
    EXPECT_EQ(BallSet::from_bits(0xffffffffU).size(), kMaxBalls);
}

TEST(BallSetDeathTest, ABallBeyondTheLimitIsOurMistake) {
    EXPECT_DEATH(BallSet{BallId{kMaxBalls}}, "CHECK");
}

}  // namespace
}  // namespace billiards::model
