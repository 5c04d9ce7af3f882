// Holds thousands of contact times, of every kind that pool has, against exact ones.
#include "common/base/elementary.h"
#include "common/base/random.h"
#include "common/physics/detect.h"
#include "common/physics/motion.h"
#include "tests/common/physics/exact_contact.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace billiards::physics {
namespace {

using base::Vec3;

/// How two balls come to meet. Their relative motion is played back from the instant at which the
/// gap is `gap_m`: whether and when they meet is the exact solver's to say.
struct Kind {
    const char* name;
    double most_speed_mps;  ///< Across the line of centres, at that instant.
    double least_closing_mps;
    double most_closing_mps;
    double acceleration_mps2;
    double least_time_s;
    double most_time_s;
    double gap_m = 0.0;
    double least_distance_m = 0.05715;
    double most_distance_m = 0.05715;
};

constexpr double kSlide = 2 * 0.2 * 9.81;  ///< Two balls that slide against each other.

constexpr Kind kKinds[] = {
    {"sliding against sliding", 8, 0.1, 8, kSlide, 0.01, 1.0},
    {"aimed", 0.1, 1, 10, kSlide, 0.05, 0.5},
    {"equal accelerations", 8, 0.1, 8, 0, 0.01, 1.0},
    {"almost equal accelerations", 8, 0.1, 8, 1e-12, 0.01, 1.0},
    {"rolling", 1, 0.001, 1, 0.2, 0.1, 10},
    {"grazing", 8, 1e-6, 1e-2, kSlide, 0.01, 1.0},
    {"tangent to rounding", 8, 0, 1e-6, kSlide, 0.01, 1.0},
    {"missing by a hair", 8, 0, 1e-6, kSlide, 0.01, 1.0, 1e-10},
    {"slow closing", 1e-3, 1e-8, 1e-4, 0.2, 0.01, 1.0},
    {"slowest closing", 1e-6, 1e-10, 1e-6, 1e-3, 0.01, 1.0},
    {"soon", 5, 0.01, 5, kSlide, 1e-9, 1e-4},
    {"long horizon", 1, 1e-3, 1, 0.02, 10, 100},
    {"small", 2, 0.01, 2, kSlide, 0.001, 0.1, 0.0, 0.002, 0.01},
    {"large", 50, 0.1, 50, kSlide, 0.1, 2, 0.0, 0.5, 2},
    {"fast and far", 60, 1, 60, 20, 0.1, 1.0},
};

double between(base::Random& random, double low, double high) {
    if (low <= 0.0 || high / low < 100.0) return random.uniform(low, high);
    return low * std::pow(high / low, random.uniform(0.0, 1.0));
}

Vec3 unit(double angle_rad) {
    return {base::cosine(angle_rad), base::sine(angle_rad), 0.0};
}

struct Meeting {
    Course course;
    double distance_m;
    double horizon_s;
};

Meeting meeting_of(const Kind& kind, base::Random& random) {
    const double time = between(random, kind.least_time_s, kind.most_time_s);
    const double distance = random.uniform(kind.least_distance_m, kind.most_distance_m);
    const double angle = random.uniform(0.0, 6.28);
    const double closing = between(random, kind.least_closing_mps, kind.most_closing_mps);
    const Vec3 then = (distance + kind.gap_m) * unit(angle);
    const Vec3 speed =
        random.uniform(-1.0, 1.0) * kind.most_speed_mps * unit(angle + 1.5707963267948966) -
        closing * unit(angle);
    const Vec3 acceleration =
        random.uniform(0.0, 1.0) * kind.acceleration_mps2 * unit(random.uniform(0.0, 6.28));
    const Vec3 start = speed - time * acceleration;
    return {{.position_m = then - time * (start + (time / 2) * acceleration),
             .velocity_mps = start,
             .acceleration_mps2 = acceleration},
            distance,
            2.0 * time};
}

/// Good to 1e-12 s + 1e-10 t, or to 1e-12 m where the gap closes slower than 1e-6 m/s. What comes
/// no nearer than 1e-12 m, or no deeper, may be met or not.
void expect_exact(const Meeting& meeting) {
    const auto& [course, distance, horizon] = meeting;
    const double found = meeting_s(course, distance, horizon);
    const auto truth = exact_descent(exact_squared_gap(course, distance), horizon);
    if (truth && found < kNever_s) {
        const Exact error = abs(*truth - found);
        if (error <= 1e-12 + 1e-10 * found) return;
        EXPECT_LT(abs(exact_rate_mps(course, *truth)), 1e-6) << "off by " << error << " s";
    }
    if (found < kNever_s) {
        EXPECT_LE(abs(exact_gap_m(course, distance, found)), 1e-12) << "at " << found;
        return;
    }
    if (!truth) return;
    const auto deep = exact_squared_gap(course, distance - kTouching_m);
    EXPECT_FALSE(exact_descent(deep, horizon)) << "missed at " << *truth;
}

TEST(ContactTruth, IsMetInEveryKindOfMeeting) {
    base::Random random(41);
    for (const Kind& kind : kKinds) {
        SCOPED_TRACE(kind.name);
        for (int i = 0; i < 400; ++i) {
            const Meeting meeting = meeting_of(kind, random);
            const double apart = glm::length(meeting.course.position_m) - meeting.distance_m;
            if (apart <= kTouching_m) continue;
            SCOPED_TRACE("meeting " + std::to_string(i));
            expect_exact(meeting);
        }
    }
}

TEST(ContactTruth, OfTouchingBallsIsNowOrWhenTheyCloseAgain) {
    base::Random random(42);
    constexpr double kDistance_m = 0.05715;
    for (int i = 0; i < 500; ++i) {
        const double angle = random.uniform(0.0, 6.28);
        Course course{.position_m = kDistance_m * unit(angle),
                      .velocity_mps = 3.0 * unit(random.uniform(0.0, 6.28)),
                      .acceleration_mps2 = 4.0 * unit(random.uniform(0.0, 6.28))};
        const double rate = glm::dot(course.velocity_mps, unit(angle));
        const double found = meeting_s(course, kDistance_m, 2.0);
        if (rate < -1e-6) {
            EXPECT_EQ(found, 0.0);
        } else if (rate > 1e-3) {
            // Rounding may have put them a hair apart or together: what counts comes later.
            const auto truth = exact_descent(exact_squared_gap(course, kDistance_m), 2.0);
            ASSERT_EQ(found < kNever_s, truth.has_value());
            EXPECT_TRUE(!truth || abs(*truth - found) <= 1e-12 + 1e-10 * found);
        }
    }
}

}  // namespace
}  // namespace billiards::physics
