// Holds contact times of single cases against what one can say by hand.
#include "common/physics/detect.h"
#include "common/physics/motion.h"
#include "tests/common/physics/exact_contact.h"

#include <cmath>
#include <gtest/gtest.h>

namespace billiards::physics {
namespace {

using base::Vec3;

constexpr double kDistance_m = 0.05715;

TEST(ContactTime, IsExactForAStraightApproach) {
    const Course course{.position_m = {1.0, 0.0, 0.0}, .velocity_mps = {-2.0, 0.0, 0.0}};
    EXPECT_NEAR(meeting_s(course, kDistance_m, 10.0), (1.0 - kDistance_m) / 2.0, 1e-15);
    EXPECT_EQ(meeting_s(course, kDistance_m, 0.4), kNever_s);
}

TEST(ContactTime, MissesByAHair) {
    Course course{.position_m = {1.0, kDistance_m + 1e-9, 0.0}, .velocity_mps = {-1.0, 0.0, 0.0}};
    EXPECT_EQ(meeting_s(course, kDistance_m, 10.0), kNever_s);
    course.position_m.y = kDistance_m - 1e-9;
    EXPECT_NEAR(meeting_s(course, kDistance_m, 10.0), 1.0, 2e-5);
}

struct Touching {
    const char* what;
    double gap_m;
    Vec3 velocity_mps;
    Vec3 acceleration_mps2;
    double time_s;
};

TEST(ContactTime, OfTouchingBallsFollowsWhetherTheyClose) {
    const double fall_s = std::sqrt(2 * kRestingDepth_m / 2.0);
    const Touching cases[] = {
        {"closing: now", 0.0, {-1, 0, 0}, {}, 0.0},
        {"closing while overlapping: now", -5e-7, {-1, 0, 0}, {}, 0.0},
        {"parting: not at all", 0.0, {1, 0, 0}, {}, kNever_s},
        {"parting while overlapping: not at all", -5e-7, {1, 0, 0}, {}, kNever_s},
        {"sliding past: not at all", 0.0, {0, 1, 0}, {}, kNever_s},
        {"at rest: not at all", 0.0, {}, {}, kNever_s},
        {"parting, coming back", 0.0, {1, 0, 0}, {-2, 0, 0}, 1.0},
        {"parting slowly, coming back", 0.0, {1e-4, 0, 0}, {-2, 0, 0}, 1e-4},
        {"pressed: when it has sunk", 0.0, {}, {-2, 0, 0}, fall_s},
        {"within rounding of closing: likewise", 0.0, {-1e-13, 0, 0}, {-2, 0, 0}, fall_s},
    };
    for (const Touching& touching : cases) {
        const Course course{.position_m = {kDistance_m + touching.gap_m, 0.0, 0.0},
                            .velocity_mps = touching.velocity_mps,
                            .acceleration_mps2 = touching.acceleration_mps2};
        const double found = meeting_s(course, kDistance_m, 10.0);
        if (touching.time_s == kNever_s) {
            EXPECT_EQ(found, kNever_s) << touching.what;
        } else {
            EXPECT_NEAR(found, touching.time_s, 1e-9) << touching.what;
        }
    }
}

TEST(ContactTime, LeavesAlmostNoGapWhereClosingIsSlow) {
    const Course course{.position_m = {kDistance_m + 1e-7, 0.0, 0.0},
                        .velocity_mps = {-5e-7, 0.0, 0.0}};
    const double found = meeting_s(course, kDistance_m, 10.0);
    EXPECT_LE(abs(exact_gap_m(course, kDistance_m, found)), 1e-12);
}

TEST(ContactTime, WithAWallCountsFromTheSideOfTheNormal) {
    const Line wall{.point_m = {0.0, 0.0}, .normal = {0.0, 1.0}};
    const Course falling{.position_m = {0.3, 1.0, 0.0}, .velocity_mps = {5.0, -2.0, 0.0}};
    EXPECT_NEAR(meeting_s(falling, wall, 0.25, 10.0), 0.375, 1e-15);
    const Course behind{.position_m = {0.3, -1.0, 0.0}, .velocity_mps = {0.0, -2.0, 0.0}};
    EXPECT_EQ(meeting_s(behind, wall, 0.25, 10.0), kNever_s);
    const Course thrown{.position_m = {0.0, 0.25, 0.0},
                        .velocity_mps = {0.0, 1.0, 0.0},
                        .acceleration_mps2 = {0.0, -4.0, 0.0}};
    EXPECT_NEAR(meeting_s(thrown, wall, 0.25, 10.0), 0.5, 1e-12);
}

TEST(ContactTime, OfACircleIsWhereThePointEntersIt) {
    const Course entering{.position_m = {1.0, 0.0, 3.0}, .velocity_mps = {-1.0, 0.0, 9.0}};
    EXPECT_NEAR(entering_s(entering, 0.25, 10.0), 0.75, 1e-15);
    const Course leaving{.position_m = {0.1, 0.0, 0.0}, .velocity_mps = {-1.0, 0.0, 0.0}};
    EXPECT_EQ(entering_s(leaving, 0.25, 10.0), kNever_s);
}

}  // namespace
}  // namespace billiards::physics
