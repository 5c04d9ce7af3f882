// Takes a ball's place and a table; gives gaps to cushions and jaws.
#include "common/physics/nearness.h"

#include "common/physics/detect.h"
#include "common/physics/forecast.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec2;
using base::Vec3;

double length_of(const Vec2& v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

Nearness wall_nearness(const TableShape& shape, const Wall& wall, const Vec3& position_m,
                       double radius_m) {
    const double side = glm::dot(wall.normal, base::horizontal(position_m) - wall.from_m);
    const Vec2 into = side > 0.0 ? -wall.normal : wall.normal;
    const double distance = std::abs(side);
    const double lean = lean_sine(shape, radius_m, position_m.z);
    if (position_m.z <= radius_m) return {distance - radius_m, into, lean};
    const Vec2 to_nose{distance - nose_setback_m(shape, radius_m), lean * radius_m};
    const double reach = length_of(to_nose);
    return {reach - radius_m, to_nose.x > 0.0 ? into : -into, to_nose.y / reach};
}

Nearness post_nearness(const TableShape& shape, const Post& post, const Vec3& position_m,
                       double radius_m) {
    const Vec2 offset = post.center_m - base::horizontal(position_m);
    const double distance = length_of(offset);
    Nearness near{.gap_m = distance - radius_m - post.radius_m,
                  .into = offset / distance,
                  .lean_sine = lean_sine(shape, radius_m, position_m.z)};
    if (position_m.z > radius_m) {
        if (near.lean_sine <= -1.0) near.gap_m = kNever_s;
        near.lean_sine = 0.0;
    }
    return near;
}

}  // namespace

Nearness nearness(const TableShape& shape, FixedIndex fixed, const Vec3& position_m,
                  double radius_m) {
    if (!is_post(shape, fixed)) {
        return wall_nearness(shape, shape.walls[fixed], position_m, radius_m);
    }
    return post_nearness(shape, shape.posts[fixed - shape.walls.size()], position_m, radius_m);
}

bool adjoin(const TableShape& shape, FixedIndex a, FixedIndex b) {
    if (is_post(shape, a) == is_post(shape, b)) return false;
    const Wall& wall = shape.walls[std::min(a, b)];
    const Post& post = shape.posts[std::max(a, b) - shape.walls.size()];
    return is_at_end(post, wall.from_m) ||
           is_at_end(post, wall.from_m + wall.length_m * wall.along);
}

void add_touching(const TableShape& shape, const Vec3& position_m, double radius_m,
                  std::vector<FixedIndex>& touching) {
    if (position_m.z <= radius_m && shape.calm.contains(base::horizontal(position_m))) return;
    constexpr double kSlack_m = 1e-9;
    // A leaning nose stands out from its line, by less than a radius.
    const double nose_reach = position_m.z > radius_m ? 2.0 * radius_m : radius_m;
    Box here;
    here.include(base::horizontal(position_m));
    const auto add_if_touching = [&](FixedIndex fixed) {
        const Nearness near = nearness(shape, fixed, position_m, radius_m);
        if (near.gap_m <= kTouching_m) touching.push_back(fixed);
    };
    for (std::size_t i = 0; i < shape.walls.size(); ++i) {
        const Wall& wall = shape.walls[i];
        if (!are_near(wall.box, here, nose_reach + kSlack_m)) continue;
        if (faces(wall, base::horizontal(position_m)))
            add_if_touching(wall_index(static_cast<int>(i)));
    }
    for (std::size_t i = 0; i < shape.posts.size(); ++i) {
        const Post& post = shape.posts[i];
        if (!are_near(post.box, here, radius_m + post.radius_m + kSlack_m)) continue;
        add_if_touching(post_index(shape, static_cast<int>(i)));
    }
}

}  // namespace billiards::physics
