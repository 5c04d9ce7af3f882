// Takes a cue ball in hand; gives whether it is held where hands put it, and red where it must not
// lie.
#include "client/play/placing.h"

#include "common/match/match.h"
#include "common/model/table_spec.h"

#include <gtest/gtest.h>

namespace billiards::client {
namespace {

match::MatchState before_the_break() {
    return *match::start({}, 1);
}

TEST(Placing, StartsAtALegalPlace) {
    const Placing placing(before_the_break());
    EXPECT_TRUE(placing.is_legal());
    EXPECT_FALSE(placing.is_down());
}

TEST(Placing, FollowsHandsButNotIntoTheCushions) {
    Placing placing(before_the_break());
    placing.hold_at({-0.9, 0.2});
    placing.move({0.0, kNudge_m});
    EXPECT_EQ(placing.position_m(), base::Vec2(-0.9, 0.201));
    placing.move({-50.0, 50.0});
    const base::Vec2 corner =
        model::table_of(model::TableSize::NineFoot).half_playing_m - model::BallSpec{}.radius_m;
    EXPECT_EQ(placing.position_m(), base::Vec2(-corner.x, corner.y));
}

TEST(Placing, IsIllegalInFrontOfTheHeadStringBeforeTheBreak) {
    Placing placing(before_the_break());
    placing.hold_at({0.0, 0.0});
    EXPECT_FALSE(placing.is_legal());
}

TEST(Placing, IsDownOnceTheServerSaysSo) {
    match::MatchState match = before_the_break();
    Placing placing(match);
    const match::Command down = match::PlaceCueBall{placing.position_m()};
    const auto step = match::apply(match, match.to_act, down);
    ASSERT_TRUE(step);
    placing.update(step->next);
    EXPECT_TRUE(placing.is_down());
    placing.move({0.0, kNudge_m});
    EXPECT_FALSE(placing.is_down());
}

}  // namespace
}  // namespace billiards::client
