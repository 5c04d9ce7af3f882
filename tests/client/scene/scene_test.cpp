// Holds the list of what is drawn against where balls, tip and rails are.
#include "client/scene/scene.h"

#include "client/scene/room.h"
#include "common/base/elementary.h"

#include <cmath>
#include <gtest/gtest.h>

namespace billiards::client {
namespace {

using base::Vec2;
using base::Vec3;
using model::TableSize;

constexpr double kRadius_m = model::BallSpec{}.radius_m;

Vec3 placed(const Drawn& drawn, const Vec3& point) {
    return Vec3(glm::dmat4(drawn.transform) * glm::dvec4(point, 1.0));
}

Vec3 tip_of(const Drawn& cue) {
    return placed(cue, {0, 0, 0});
}
Vec3 butt_of(const Drawn& cue) {
    return placed(cue, {-kCueLength_m, 0, 0});
}

ShownBall ball_at(std::uint8_t number, const Vec3& place) {
    return {.ball = {number}, .radius_m = kRadius_m, .state = {.position_m = place}};
}

const model::TableSpec& table() {
    return model::table_of(TableSize::NineFoot);
}

TEST(Scene, EveryObjectCanBeLoaded) {
    std::vector<ShownBall> balls;
    for (std::uint8_t number = 0; number < model::kMaxBalls; ++number) {
        balls.push_back(ball_at(number, {0, 0, kRadius_m}));
    }
    for (const TableSize size : {TableSize::SevenFoot, TableSize::EightFoot, TableSize::NineFoot}) {
        for (const Detail detail : {Detail::Fine, Detail::Coarse}) {
            for (const Drawn& drawn : scene_of(size, balls, {}, HeldCue{}, detail)) {
                const auto meshes = load_model(ASSETS_FOLDER, drawn.model);
                EXPECT_TRUE(meshes.ok()) << in_words(meshes.error());
                EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(ASSETS_FOLDER) /
                                                    drawn.model.texture_path));
            }
        }
    }
}

TEST(Scene, HoldsTheTableTheBallsWithTheirShadesAndTheCue) {
    const std::vector balls{ball_at(0, {0, 0, kRadius_m}), ball_at(8, {0.5, 0, kRadius_m})};
    const std::size_t table_parts = drawn_table(TableSize::EightFoot).size();
    EXPECT_EQ(scene_of(TableSize::EightFoot, balls, {}, std::nullopt).size(), table_parts + 4);
    EXPECT_EQ(scene_of(TableSize::EightFoot, balls, {}, HeldCue{}).size(), table_parts + 5);
}

TEST(DrawnShade, LiesOnTheClothUnderItsBallAndShrinksWithItsHeight) {
    const Vec3 place{0.4, -0.2, kRadius_m};
    const Vec3 above{0.4, -0.2, 1.5 * kRadius_m};
    const auto resting = drawn_shade(ball_at(1, place));
    const auto hopping = drawn_shade(ball_at(1, above));
    ASSERT_TRUE(resting && hopping);
    EXPECT_TRUE(resting->is_shade);
    const Vec3 middle = placed(*resting, {0, 0, 0});
    EXPECT_LT(glm::distance(middle, Vec3(place.x, place.y, 0.0)), 0.001);
    EXPECT_LT(glm::distance(placed(*hopping, {1, 0, 0}), middle),
              glm::distance(placed(*resting, {1, 0, 0}), middle));
}

TEST(DrawnShade, IsNotThereUnderABallThatDropsOrFlies) {
    EXPECT_FALSE(drawn_shade(ball_at(1, {0.4, -0.2, 0.0})));
    EXPECT_FALSE(drawn_shade(ball_at(1, {0.4, -0.2, 3 * kRadius_m})));
}

TEST(DrawnBall, HasItsOwnPicturePlaceAndSize) {
    const Vec3 place{0.4, -0.2, kRadius_m};
    const Drawn drawn = drawn_ball(ball_at(11, place), glm::dquat(1, 0, 0, 0), Detail::Fine);
    EXPECT_EQ(drawn.model.texture_path, "textures/ball_11.bmp");
    EXPECT_LT(glm::distance(placed(drawn, {0, 0, 0}), place), 1e-6);
    EXPECT_LT(glm::distance(placed(drawn, {0, 0, 1}), place + Vec3(0, 0, kRadius_m)), 1e-6);
}

TEST(DrawnBall, IsTurnedAsItsOrientationSays) {
    const glm::dquat quarter = glm::angleAxis(base::kPi / 2, Vec3(0, 1, 0));
    const Drawn drawn = drawn_ball(ball_at(1, {0, 0, kRadius_m}), quarter, Detail::Fine);
    EXPECT_LT(glm::distance(placed(drawn, {0, 0, 1}), Vec3(kRadius_m, 0, kRadius_m)), 1e-6);
}

TEST(DrawnCue, TouchesTheBallBehindItsCentreAndPointsWhereTheShotGoes) {
    const double angle = 0.7;
    const Drawn cue =
        drawn_cue({.ball_m = {0.1, 0.2}, .shot = {.angle_rad = angle}}, model::open_table());
    const Vec3 along(std::cos(angle), std::sin(angle), 0);
    EXPECT_LT(glm::distance(tip_of(cue), Vec3(0.1, 0.2, kRadius_m) - kRadius_m * along), 1e-6);
    const Vec2 forward = glm::normalize(base::horizontal(tip_of(cue) - butt_of(cue)));
    EXPECT_LT(glm::distance(forward, Vec2(along)), 1e-6);
}

TEST(DrawnCue, IsDrawnBackAlongItself) {
    const HeldCue at_ball{.ball_m = {0, 0}, .shot = {.elevation_rad = 0.5}};
    HeldCue pulled = at_ball;
    pulled.drawn_back_m = 0.3;
    const Drawn there = drawn_cue(at_ball, table());
    const Drawn back = drawn_cue(pulled, table());
    const Vec3 forward = glm::normalize(tip_of(there) - butt_of(there));
    EXPECT_LT(glm::distance(tip_of(back), tip_of(there) - 0.3 * forward), 1e-6);
}

TEST(DrawnCue, StrikesLeftOrAboveWhereTheShotSays) {
    const Drawn left = drawn_cue({.shot = {.tip_left = 0.4}}, model::open_table());
    EXPECT_NEAR(tip_of(left).y, 0.4 * kRadius_m, 1e-6);
    const Drawn high = drawn_cue({.shot = {.tip_up = 0.4}}, model::open_table());
    EXPECT_NEAR(tip_of(high).z, 1.4 * kRadius_m, 1e-6);
    for (const Drawn& cue : {left, high}) {
        EXPECT_NEAR(glm::distance(tip_of(cue), Vec3(0, 0, kRadius_m)), kRadius_m, 1e-6);
    }
}

TEST(DrawnCue, IsRaisedAsTheShotSays) {
    const Drawn cue = drawn_cue({.shot = {.elevation_rad = 0.9}}, table());
    EXPECT_NEAR(butt_of(cue).z - tip_of(cue).z, kCueLength_m * std::sin(0.9), 1e-6);
}

TEST(DrawnCue, NeverPassesThroughTheRailBehindIt) {
    const Vec2 half = table().half_playing_m;
    for (double x = -half.x + 0.10; x < half.x; x += 0.1) {
        for (double angle = 0.0; angle < 6.28; angle += 0.1) {
            const Drawn cue =
                drawn_cue({.ball_m = {x, 0.3}, .shot = {.angle_rad = angle}}, table());
            for (double back = 0.0; back <= kCueLength_m; back += 0.01) {
                const Vec3 point = placed(cue, {-back, 0, 0});
                const bool is_over_table =
                    std::fabs(point.x) < half.x && std::fabs(point.y) < half.y;
                if (!is_over_table) {
                    EXPECT_GT(point.z, table().nose_height_m + 0.01);
                }
            }
        }
    }
}

}  // namespace
}  // namespace billiards::client
