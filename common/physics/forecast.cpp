// Takes balls with plans and a table; gives times of contact, of falling and of leaving.
#include "common/physics/forecast.h"

#include "common/physics/detect.h"

#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec2;
using base::Vec3;

/// Boxes are compared with this to spare, so that bodies that touch are never missed.
constexpr double kBoxSlack_m = 1e-9;

/// Where a centre can be between now and the horizon: ends, and turning points of the parabola.
Box swept_by(const Course& course, double horizon_s) {
    constexpr double kLongest_s = 1e9;  // A ball without friction moves for ever.
    const double horizon = std::min(horizon_s, kLongest_s);
    Box box;
    for (int axis = 0; axis < 2; ++axis) {
        const double p = course.position_m[axis];
        const double v = course.velocity_mps[axis];
        const double a = course.acceleration_mps2[axis];
        const double q = p + (v + a * (horizon / 2)) * horizon;
        box.low[axis] = std::min(p, q);
        box.high[axis] = std::max(p, q);
        if (v * (v + a * horizon) < 0.0) {
            const double turning = p - v * v / (2 * a);
            box.low[axis] = std::min(box.low[axis], turning);
            box.high[axis] = std::max(box.high[axis], turning);
        }
    }
    return box;
}

/// Looks through what stands on the table for the first thing that one ball comes to.
class Lookout {
  public:
    Lookout(const TableShape& shape, const Mover& mover, double now_s)
        : shape_(shape),
          now_s_(now_s),
          course_(course_at(mover.plan.segment, now_s)),
          radius_(mover.spec.radius_m),
          is_airborne_(mover.plan.segment.motion == model::Motion::Airborne),
          is_over_rail_(is_airborne_ &&
                        is_behind_nose(shape, base::horizontal(course_.position_m))),
          first_{.time_s = mover.plan.end_s} {}

    Next look() {
        reach_ = swept_by(course_, horizon_s());
        if (!is_airborne_ && shape_.calm.contains(reach_)) return first_;
        if (!is_over_rail_) look_at_fixed();
        if (shape_.has_edge) look_at_edge();
        return first_;
    }

    Box swept() const { return swept_by(course_, horizon_s()); }

  private:
    double horizon_s() const { return first_.time_s - now_s_; }

    /// The walls first: they are long, and mostly they bring the horizon near.
    void look_at_fixed() {
        for (std::size_t i = 0; i < shape_.walls.size(); ++i) look_at_wall(i);
        reach_ = swept_by(course_, horizon_s());
        for (std::size_t i = 0; i < shape_.posts.size(); ++i) look_at_post(i);
        for (std::size_t i = 0; i < shape_.pockets.size(); ++i) look_at_pocket(i);
    }

    void offer(double after_s, Cause cause, std::size_t index) {
        if (now_s_ + after_s >= first_.time_s) return;
        first_ = {.time_s = now_s_ + after_s, .cause = cause, .index = static_cast<int>(index)};
    }

    Vec3 position_after(double time_s) const {
        return course_.position_m +
               (course_.velocity_mps + course_.acceleration_mps2 * (time_s / 2)) * time_s;
    }

    /// Segments stop a ball from either side.
    void look_at_wall(std::size_t index) {
        const Wall& wall = shape_.walls[index];
        // A leaning nose stands out from its line, by less than a radius.
        const double distance = is_airborne_ ? 2.0 * radius_ : radius_;
        if (!are_near(wall.box, reach_, distance + kBoxSlack_m)) return;
        for (const double side : {1.0, -1.0}) {
            const Line line{wall.from_m, side * wall.normal};
            const double time = is_airborne_ ? nose_meeting_s(line)
                                             : meeting_s(course_, line, radius_, horizon_s());
            if (time < kNever_s && faces(wall, base::horizontal(position_after(time)))) {
                offer(time, Cause::Wall, index);
            }
        }
    }

    bool is_on_side_of(const Line& line, double time_s) const {
        const Vec2 then = base::horizontal(position_after(time_s));
        return glm::dot(line.normal, then - line.point_m) > 0.0;
    }

    /// An airborne ball meets the nose by its true height: distance R in the plane across it. Each
    /// side of a wall has its own nose; a ball that has flown over it is past it.
    double nose_meeting_s(const Line& line) const {
        if (!is_on_side_of(line, 0.0)) return kNever_s;
        const auto across = [&](const Vec3& v) {
            return glm::dot(line.normal, base::horizontal(v));
        };
        const Vec2 offset = base::horizontal(course_.position_m) - line.point_m;
        const Course from_nose{
            .position_m = {glm::dot(line.normal, offset) - nose_setback_m(shape_, radius_), 0.0,
                           course_.position_m.z - shape_.nose_height_m},
            .velocity_mps = {across(course_.velocity_mps), 0.0, course_.velocity_mps.z},
            .acceleration_mps2 = {across(course_.acceleration_mps2), 0.0,
                                  course_.acceleration_mps2.z}};
        const double time = meeting_s(from_nose, radius_, horizon_s());
        return time < kNever_s && is_on_side_of(line, time) ? time : kNever_s;
    }

    Course from(const Vec2& center) const {
        return {
            .position_m = {course_.position_m.x - center.x, course_.position_m.y - center.y, 0.0},
            .velocity_mps = {course_.velocity_mps.x, course_.velocity_mps.y, 0.0},
            .acceleration_mps2 = {course_.acceleration_mps2.x, course_.acceleration_mps2.y, 0.0}};
    }

    /// To an airborne ball a jaw is an upright cylinder, as high as a nose reaches.
    void look_at_post(std::size_t index) {
        const Post& post = shape_.posts[index];
        const double distance = post.radius_m + radius_;
        if (!are_near(post.box, reach_, distance + kBoxSlack_m)) return;
        const double time = meeting_s(from(post.center_m), distance, horizon_s());
        if (time == kNever_s) return;
        if (is_airborne_ && lean_sine(shape_, radius_, position_after(time).z) <= -1.0) return;
        offer(time, Cause::Post, index);
    }

    /// A ball in the air falls into a pocket where its underside is below the noses.
    void look_at_pocket(std::size_t index) {
        const Pocket& pocket = shape_.pockets[index];
        if (!are_near(pocket.box, reach_, pocket.radius_m + kBoxSlack_m)) return;
        const double time = entering_s(from(pocket.center_m), pocket.radius_m, horizon_s());
        if (time == kNever_s) return;
        if (is_airborne_ && position_after(time).z - radius_ >= shape_.nose_height_m) return;
        offer(time, Cause::Pocket, index);
    }

    void look_at_edge() {
        for (int axis = 0; axis < 2; ++axis) {
            const double p = course_.position_m[axis];
            const double v = course_.velocity_mps[axis];
            const double a = course_.acceleration_mps2[axis];
            const double high = shape_.edge.high[axis];
            const double low = shape_.edge.low[axis];
            if (reach_.high[axis] > high)
                offer(falling_s(high - p, -v, -a, horizon_s()), Cause::Edge, 0);
            if (reach_.low[axis] < low)
                offer(falling_s(p - low, v, a, horizon_s()), Cause::Edge, 0);
        }
    }

    const TableShape& shape_;
    double now_s_;
    Course course_;
    double radius_;
    bool is_airborne_;
    bool is_over_rail_;
    Next first_;
    Box reach_;
};

}  // namespace

void foresee_alone(const TableShape& shape, Mover& mover, double now_s) {
    if (!is_travelling(mover.plan.segment.motion)) {
        mover.alone = {.time_s = mover.plan.end_s};
        mover.swept = {};
        mover.swept.include(base::horizontal(mover.plan.segment.position_m));
        return;
    }
    Lookout lookout(shape, mover, now_s);
    mover.alone = lookout.look();
    mover.swept = lookout.swept();
}

double meeting_time_s(const Mover& a, const Mover& b, double now_s) {
    const double distance = a.spec.radius_m + b.spec.radius_m;
    if (!are_near(a.swept, b.swept, distance + kBoxSlack_m)) return kNever_s;
    if (!is_travelling(a.plan.segment.motion) && !is_travelling(b.plan.segment.motion)) {
        return kNever_s;
    }
    const Course from_a = course_at(a.plan.segment, now_s);
    const Course from_b = course_at(b.plan.segment, now_s);
    const Course difference{
        .position_m = from_b.position_m - from_a.position_m,
        .velocity_mps = from_b.velocity_mps - from_a.velocity_mps,
        .acceleration_mps2 = from_b.acceleration_mps2 - from_a.acceleration_mps2};
    const double horizon = std::min(a.alone.time_s, b.alone.time_s) - now_s;
    return now_s + meeting_s(difference, distance, horizon);
}

double lean_sine(const TableShape& shape, double radius_m, double height_m) {
    return (shape.nose_height_m - height_m) / radius_m;
}

double nose_setback_m(const TableShape& shape, double radius_m) {
    const double sine = lean_sine(shape, radius_m, radius_m);
    return radius_m * (1.0 - std::sqrt(std::max(0.0, 1.0 - sine * sine)));
}

}  // namespace billiards::physics
