// Takes calls; gives whether those that may be said are known, and those that were made.
#include "common/rules/called_shot.h"

#include "tests/common/rules/told_shot.h"

#include <gtest/gtest.h>

namespace billiards::rules {
namespace {

TEST(CalledShot, IsASafetyOrABallThatMayBeCalledInAPocketThatExists) {
    const model::BallSet may = balls({2, 15});
    EXPECT_TRUE(is_shot_call(may, call(2, 0)));
    EXPECT_TRUE(is_shot_call(may, call(15, 5)));
    EXPECT_TRUE(is_shot_call(may, model::Safety{}));
    EXPECT_FALSE(is_shot_call(may, call(3, 0)));
    EXPECT_FALSE(is_shot_call(may, call(0, 0)));
    EXPECT_FALSE(is_shot_call(may, call(255, 0)));
    EXPECT_FALSE(is_shot_call(may, call(2, 6)));
    EXPECT_FALSE(is_shot_call(may, model::NoCall{}));
    EXPECT_FALSE(is_shot_call(may, model::PushOut{}));
}

TEST(CalledShot, IsMadeOnlyByTheBallInItsPocket) {
    const Facts facts = ToldShot().hits(9).pots(9, 4).pots(2, 1).facts();
    const auto down = [&](const model::Call& said) {
        return called_ball_down(balls({2, 3, 9}), said, facts);
    };
    EXPECT_EQ(down(call(2, 1)), ToldShot::id(2));
    EXPECT_EQ(down(call(9, 4)), ToldShot::id(9));
    EXPECT_EQ(down(call(2, 4)), std::nullopt);
    EXPECT_EQ(down(call(3, 4)), std::nullopt);
    EXPECT_EQ(down(model::NoCall{}), std::nullopt);
    EXPECT_EQ(down(model::Safety{}), std::nullopt);
}

TEST(CalledShot, IsNotMadeByABallThatMayNotBeCalled) {
    const Facts facts = ToldShot().hits(9).pots(9, 4).facts();
    EXPECT_EQ(called_ball_down(balls({2}), call(9, 4), facts), std::nullopt);
}

}  // namespace
}  // namespace billiards::rules
