// Takes hands on the view; gives whether the eye stays where eyes can be, and sees what it should.
#include "client/scene/camera.h"

#include <gtest/gtest.h>

namespace billiards::client {
namespace {

constexpr base::Vec2 kHalfTable{1.42, 0.785};
constexpr double kAspect = 980.0 / 720.0;

bool sees(const Camera& camera, const base::Vec3& point_m) {
    const auto place = camera.place_of(point_m, kAspect);
    return place && std::abs(place->x) <= 1.0 && std::abs(place->y) <= 1.0;
}

TEST(Camera, SeesTheWholeTableAfterAReset) {
    Camera camera(kHalfTable);
    for (int view = 0; view < 2; ++view, camera.look_from_above()) {
        for (const double x : {-kHalfTable.x, kHalfTable.x}) {
            for (const double y : {-kHalfTable.y, kHalfTable.y}) {
                EXPECT_TRUE(sees(camera, {x, y, 0.0})) << view << ": " << x << ", " << y;
            }
        }
    }
}

TEST(Camera, FindsThePointOnTheBedThatIsDrawnAtAPlace) {
    const Camera camera(kHalfTable);
    const base::Vec3 point{0.4, -0.2, 0.0};
    const auto place = camera.place_of(point, kAspect);
    ASSERT_TRUE(place);
    const auto found = camera.point_at(*place, kAspect, 0.0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, point.x, 1e-5);
    EXPECT_NEAR(found->y, point.y, 1e-5);
}

TEST(Camera, FindsNoPointAboveTheHorizon) {
    Camera camera(kHalfTable);
    camera.orbit(0.0, -10.0);
    EXPECT_FALSE(camera.point_at({0.0, 1.0}, kAspect, 0.0));
}

TEST(Camera, SeesNothingBehindItself) {
    const Camera camera(kHalfTable);
    EXPECT_FALSE(camera.place_of(2.0 * camera.eye_m(), kAspect));
}

TEST(Camera, NeverGoesBelowTheBedNorOverTheTop) {
    Camera camera(kHalfTable);
    camera.orbit(0.3, -100.0);
    EXPECT_GT(camera.eye_m().z, 0.0);
    camera.orbit(0.3, 100.0);
    EXPECT_LT(camera.elevation_rad(), 1.5708);
}

TEST(Camera, ZoomsWithinLimitsAndBack) {
    Camera camera(kHalfTable);
    const double usual_m = camera.distance_m();
    camera.zoom(1);
    EXPECT_LT(camera.distance_m(), usual_m);
    camera.zoom(1000);
    EXPECT_GT(camera.distance_m(), 0.1);
    camera.zoom(-1000);
    EXPECT_LT(camera.distance_m(), 10.0);
    camera.reset_zoom();
    EXPECT_EQ(camera.distance_m(), usual_m);
}

TEST(Camera, TurnsAboutTheBallThatItFollows) {
    Camera camera(kHalfTable);
    camera.follow(base::Vec3{0.5, 0.3, 0.03});
    const auto place = camera.place_of({0.5, 0.3, 0.03}, kAspect);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 0.0, 1e-6);
    EXPECT_NEAR(place->y, 0.0, 1e-6);
    camera.follow(std::nullopt);
    EXPECT_EQ(camera.target_m(), base::Vec3{});
}

TEST(Camera, ComesBackToItsFirstViewAfterAllOfThem) {
    Camera camera(kHalfTable);
    const base::Vec3 first = camera.eye_m();
    camera.next_view();
    EXPECT_NE(camera.eye_m(), first);
    for (int i = 0; i < 3; ++i) camera.next_view();
    EXPECT_EQ(camera.eye_m(), first);
}

}  // namespace
}  // namespace billiards::client
