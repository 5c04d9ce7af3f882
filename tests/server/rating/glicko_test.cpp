// Holds the rating against its author's worked example and what every rating must keep.
#include "server/rating/glicko.h"

#include <array>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace billiards::server {
namespace {

constexpr double kYear_d = 365.0;

Rating after_one(const Rating& before, const Rating& opponent, double score) {
    return rated(before, std::array{RatedGame{opponent, score}});
}

TEST(Glicko, GivesTheWorkedExampleOfItsAuthor) {
    const std::array games{RatedGame{{1400, 30}, 1.0}, RatedGame{{1550, 100}, 0.0},
                           RatedGame{{1700, 300}, 0.0}};
    const Rating after = rated({1500, 200}, games);
    EXPECT_NEAR(after.rating, 1464.06, 0.05);
    EXPECT_NEAR(after.deviation, 151.4, 0.05);
}

TEST(Glicko, LeavesWhoeverDidNotPlayAsTheyWere) {
    const Rating after = rated({1620, 80}, {});
    EXPECT_DOUBLE_EQ(after.rating, 1620);
    EXPECT_DOUBLE_EQ(after.deviation, 80);
}

TEST(Glicko, GrowsFromTheUsualDeviationToTheMostInItsTime) {
    EXPECT_NEAR(rested({1500, kUsualDeviation}, kForgottenAfter_d).deviation, kMostDeviation, 1e-9);
    EXPECT_LT(rested({1500, kUsualDeviation}, kForgottenAfter_d - 1).deviation, kMostDeviation);
    EXPECT_EQ(rested({1500, kMostDeviation}, kYear_d).deviation, kMostDeviation);
}

TEST(Glicko, TakesAClockThatJumpedBackForNoRest) {
    EXPECT_EQ(rested({1500, 80}, -kYear_d), rested({1500, 80}, 0));
}

TEST(Glicko, NeverKnowsAPlayerBetterThanTheLeastDeviation) {
    Rating player{1500, 60};
    for (int game = 0; game < 500; ++game) player = after_one(player, {1500, 30}, 0.5);
    EXPECT_EQ(player.deviation, kLeastDeviation);
}

TEST(Glicko, ADrawBetweenEqualsMovesNeither) {
    EXPECT_NEAR(after_one({1500, 100}, {1500, 200}, 0.5).rating, 1500, 1e-9);
}

Rating any_rating() {
    return {.rating = *rc::gen::inRange(0, 3000) * 1.0,
            .deviation = *rc::gen::inRange(30, 351) * 1.0};
}

RC_GTEST_PROP(Glicko, AWinNeverLowersALossNeverRaisesAndWhatIsKnownNeverShrinks, ()) {
    const Rating before = any_rating();
    const Rating opponent = any_rating();
    RC_ASSERT(after_one(before, opponent, 1.0).rating >= before.rating);
    RC_ASSERT(after_one(before, opponent, 0.0).rating <= before.rating);
    const double drawn = after_one(before, opponent, 0.5).rating;
    RC_ASSERT(drawn <= after_one(before, opponent, 1.0).rating);
    RC_ASSERT(drawn >= after_one(before, opponent, 0.0).rating);
    RC_ASSERT(after_one(before, opponent, 1.0).deviation <= before.deviation);
}

RC_GTEST_PROP(Glicko, RestMovesNoRatingAndKeepsTheDeviationInItsBounds, ()) {
    const Rating before = any_rating();
    const Rating after = rested(before, *rc::gen::inRange(-10, 10'000));
    RC_ASSERT(after.rating == before.rating);
    RC_ASSERT(after.deviation >= before.deviation);
    RC_ASSERT(after.deviation <= kMostDeviation);
}

}  // namespace
}  // namespace billiards::server
