// Takes two motions; gives the time of their next contact.
#include "common/physics/detect.h"

#include "common/physics/double_double.h"
#include "common/physics/motion.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec2;
using base::Vec3;

/// Touching bodies that part slower than this come back before rounding can tell that they opened.
constexpr double kSlowParting_mps = 1e-6;

/// Touching bodies that come this far apart have opened: twice what touching means, so that
/// rounding cannot take one for the other.
constexpr double kOpened_m = 2e-12;

/// The rules of contact, over descent_to(gap), the first time at which the gap falls through a
/// value having been above it, and meeting_after(time), the same question asked later.
template <class DescentTo, class MeetingAfter>
double next_contact_s(double gap_m, double rate_mps, DescentTo descent_to,
                      MeetingAfter meeting_after) {
    if (gap_m > kTouching_m) return descent_to(0.0);
    if (rate_mps < -kClosing_mps) return 0.0;
    const bool has_sunk = gap_m < -1.5 * kRestingDepth_m ||
                          (gap_m < -0.9 * kRestingDepth_m && rate_mps < kSlowParting_mps);
    const double sinking = descent_to(has_sunk ? gap_m - kRestingDepth_m : -kRestingDepth_m);
    const double closing_again = descent_to(kOpened_m);
    return closing_again < sinking ? meeting_after(closing_again) : sinking;
}

Course course_after(const Course& course, double time_s) {
    return {.position_m = course.position_m +
                          (course.velocity_mps + course.acceleration_mps2 * (time_s / 2)) * time_s,
            .velocity_mps = course.velocity_mps + course.acceleration_mps2 * time_s,
            .acceleration_mps2 = course.acceleration_mps2};
}

/// |d + v t + a t^2 / 2|^2 - distance^2.
Polynomial squared_distance(const Course& course, double distance_m) {
    const Vec3& d = course.position_m;
    const Vec3& v = course.velocity_mps;
    const Vec3& a = course.acceleration_mps2;
    return {{glm::dot(d, d) - distance_m * distance_m, 2.0 * glm::dot(d, v),
             glm::dot(v, v) + glm::dot(d, a), glm::dot(v, a), 0.25 * glm::dot(a, a)}};
}

bool is_still(const Course& course) {
    return course.velocity_mps == Vec3{} && course.acceleration_mps2 == Vec3{};
}

/// The same at one time, without the cancellation that a graze or a far start suffers.
double careful_squared_gap(const Course& course, double distance_m, double time_s) {
    const DoubleDouble t{time_s};
    const DoubleDouble half_t_squared = exact_product(0.5 * time_s, time_s);
    DoubleDouble sum = exact_product(-distance_m, distance_m);
    for (int axis = 0; axis < 3; ++axis) {
        const DoubleDouble place = DoubleDouble{course.position_m[axis]} +
                                   DoubleDouble{course.velocity_mps[axis]} * t +
                                   DoubleDouble{course.acceleration_mps2[axis]} * half_t_squared;
        sum = sum + place * place;
    }
    return sum.high;
}

/// Steps to the falling root of the parabola that touches the squared gap here: near a graze, where
/// two roots are close, a straight line would take one for the other.
double carefully_polished(const Course& course, double distance_m, double time_s) {
    double value = careful_squared_gap(course, distance_m, time_s);
    constexpr int kMostSteps = 4;
    for (int step = 0; step < kMostSteps && value != 0.0; ++step) {
        const Course then = course_after(course, time_s);
        const Vec3& x = then.position_m;
        const Vec3& v = then.velocity_mps;
        const double rate = 2.0 * glm::dot(x, v);
        const double bend = 2.0 * (glm::dot(v, v) + glm::dot(x, course.acceleration_mps2));
        const double squared = rate * rate - 2.0 * bend * value;
        if (squared < 0.0) return time_s;
        const double root = std::sqrt(squared);
        const double change = rate < 0.0 ? 2.0 * value / (root - rate) : -(rate + root) / bend;
        const double next = std::max(0.0, time_s + change);
        const double next_value = careful_squared_gap(course, distance_m, next);
        if (!(std::abs(next_value) < std::abs(value))) return time_s;
        time_s = next;
        value = next_value;
    }
    return time_s;
}

/// One Newton step on the gap itself, whose rounding is smaller than that of its square; where even
/// that is too much for the slope, more.
double polished(const Course& course, double distance_m, double time_s) {
    constexpr double kRounding = 4e-16;
    constexpr double kEnough_s = 1e-13;
    constexpr double kEnough = 1e-11;  // Of the time: ten times better than promised.
    const Course then = course_after(course, time_s);
    const double distance = std::sqrt(glm::dot(then.position_m, then.position_m));
    const double rate = glm::dot(then.position_m, then.velocity_mps) / distance;
    const double step = (distance - distance_m) / rate;
    const double reach =
        distance + time_s * std::sqrt(glm::dot(course.velocity_mps, course.velocity_mps));
    const bool is_steep = kRounding * reach < std::abs(rate) * (kEnough_s + kEnough * time_s);
    if (is_steep && std::abs(step) < 1e-9) return std::max(0.0, time_s - step);
    return carefully_polished(course, distance_m, time_s);
}

}  // namespace

double meeting_s(const Course& difference, double distance_m, double horizon_s) {
    if (is_still(difference)) return kNever_s;
    const double distance = std::sqrt(glm::dot(difference.position_m, difference.position_m));
    const double rate = glm::dot(difference.position_m, difference.velocity_mps) / distance;
    const Polynomial gap_squared = squared_distance(difference, distance_m);
    const auto descent_to = [&](double gap) {
        Polynomial p = gap_squared;
        p.c[0] -= gap * (2.0 * distance_m + gap);
        const double time = first_descent(p, horizon_s);
        return time < kNever_s ? polished(difference, distance_m + gap, time) : kNever_s;
    };
    return next_contact_s(distance - distance_m, rate, descent_to, [&](double time) {
        return time + meeting_s(course_after(difference, time), distance_m, horizon_s - time);
    });
}

double meeting_s(const Course& course, const Line& line, double distance_m, double horizon_s) {
    const Vec2 offset = base::horizontal(course.position_m) - line.point_m;
    const double gap = glm::dot(line.normal, offset) - distance_m;
    const double rate = glm::dot(line.normal, base::horizontal(course.velocity_mps));
    const double acceleration = glm::dot(line.normal, base::horizontal(course.acceleration_mps2));
    if (rate == 0.0 && acceleration == 0.0) return kNever_s;
    const bool is_behind = gap < -distance_m;
    if (is_behind) return falling_s(gap, rate, acceleration, horizon_s);
    const auto descent_to = [&](double target) {
        return falling_s(gap - target, rate, acceleration, horizon_s);
    };
    // A parabola that opened and closes again does so once.
    return next_contact_s(gap, rate, descent_to, [&](double) { return descent_to(0.0); });
}

double entering_s(const Course& difference, double radius_m, double horizon_s) {
    Course flat = difference;
    flat.position_m.z = flat.velocity_mps.z = flat.acceleration_mps2.z = 0.0;
    if (is_still(flat)) return kNever_s;
    return first_descent(squared_distance(flat, radius_m), horizon_s);
}

double falling_s(double value, double rate, double acceleration, double horizon_s) {
    // Of a parabola's two roots t = (-b +- sqrt(D)) / a the falling one has the slope -sqrt(D);
    // each sign of b has the form of it that does not cancel.
    const double discriminant = rate * rate - 2.0 * acceleration * value;
    if (discriminant < 0.0) return kNever_s;
    const double root = std::sqrt(discriminant);
    const double time = rate > 0.0 ? -(rate + root) / acceleration : 2.0 * value / (root - rate);
    return time > 0.0 && time <= horizon_s ? time : kNever_s;
}

}  // namespace billiards::physics
