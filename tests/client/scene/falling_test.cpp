// Holds balls that drop into pockets against the pocket's walls.
#include "client/scene/falling.h"

#include <gtest/gtest.h>

namespace billiards::client {
namespace {

constexpr double kRadius_m = 0.028575;
constexpr double kPocketed_s = 0.4;

const model::TableSpec& table() {
    return model::table_of(model::TableSize::NineFoot);
}

/// Rolls towards side pocket 1, and is pocketed where it enters the circle.
timeline::Timeline pocketed_at(double speed_mps) {
    const model::PocketCircle& pocket = table().pockets[1];
    const base::Vec3 edge(pocket.center_m + base::Vec2(0, pocket.radius_m), kRadius_m);
    const base::Vec3 velocity(0, -speed_mps, 0);
    return {
        {{.ball = model::BallId{4},
          .radius_m = kRadius_m,
          .segments = {
              {.position_m = edge - kPocketed_s * velocity,
               .velocity_mps = velocity,
               .motion = model::Motion::Rolling},
              {.start_s = kPocketed_s, .position_m = edge, .motion = model::Motion::Pocketed}}}}};
}

TEST(FallingBalls, AreNoneBeforeAndLongAfter) {
    EXPECT_TRUE(falling_balls(pocketed_at(1.0), table(), kPocketed_s - 0.01).empty());
    EXPECT_TRUE(falling_balls(pocketed_at(1.0), table(), kPocketed_s + 0.5).empty());
}

TEST(FallingBalls, StartWhereTheyEntered) {
    const auto falling = falling_balls(pocketed_at(1.0), table(), kPocketed_s);
    ASSERT_EQ(falling.size(), 1U);
    EXPECT_EQ(falling.front().ball, model::BallId{4});
    EXPECT_NEAR(falling.front().state.position_m.z, kRadius_m, 1e-12);
}

TEST(FallingBalls, FallAndStayWithinThePocket) {
    for (const double speed_mps : {0.01, 1.0, 8.0}) {
        double height_m = kRadius_m;
        for (double fallen_s = 0.01; fallen_s < 0.15; fallen_s += 0.01) {
            const auto falling =
                falling_balls(pocketed_at(speed_mps), table(), kPocketed_s + fallen_s);
            ASSERT_EQ(falling.size(), 1U);
            const base::Vec3& place = falling.front().state.position_m;
            EXPECT_LT(place.z, height_m);
            height_m = place.z;
            const model::PocketCircle& pocket = table().pockets[1];
            const double off = glm::distance(base::horizontal(place), pocket.center_m);
            EXPECT_LT(off, pocket.radius_m);
            if (fallen_s > 0.06) {
                EXPECT_LT(off, pocket.radius_m - kRadius_m + 1e-9);
            }
        }
    }
}

TEST(FallingBalls, AreNotTheOnesThatLayInAPocketBeforeTheShot) {
    timeline::Timeline timeline = pocketed_at(1.0);
    timeline.tracks[0].segments.erase(timeline.tracks[0].segments.begin());
    timeline.tracks[0].segments[0].start_s = 0.0;
    EXPECT_TRUE(falling_balls(timeline, table(), 0.0).empty());
}

}  // namespace
}  // namespace billiards::client
