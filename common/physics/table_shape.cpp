// Takes a table as data; gives its walls, posts, pockets and edge.
#include "common/physics/table_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace billiards::physics {

namespace {

using base::Vec2;

double length_of(const Vec2& v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

Wall wall_of(const model::CushionSegment& segment) {
    Wall wall{.from_m = segment.from_m};
    const Vec2 span = segment.to_m - segment.from_m;
    wall.length_m = length_of(span);
    wall.along = span / wall.length_m;
    wall.normal = {-wall.along.y, wall.along.x};
    wall.box.include(segment.from_m);
    wall.box.include(segment.to_m);
    return wall;
}

Post post_at(const Vec2& center, double radius_m) {
    Post post{.center_m = center, .radius_m = radius_m};
    post.box.include(center);
    return post;
}

Pocket pocket_of(const model::PocketCircle& circle, const std::vector<model::JawArc>& jaws) {
    Pocket pocket{.center_m = circle.center_m, .radius_m = circle.radius_m};
    pocket.mouth_m = std::numeric_limits<double>::infinity();
    for (const model::JawArc& jaw : jaws) {
        pocket.mouth_m = std::min(pocket.mouth_m, length_of(jaw.center_m - circle.center_m));
    }
    pocket.box.include(circle.center_m);
    return pocket;
}

bool has_post(const std::vector<Post>& posts, const Vec2& end) {
    return std::any_of(posts.begin(), posts.end(),
                       [&](const Post& post) { return is_at_end(post, end); });
}

}  // namespace

TableShape::TableShape(const model::TableSpec& table, double largest_radius_m)
    : nose_height_m(table.nose_height_m) {
    walls.reserve(table.cushions.size());
    for (const model::CushionSegment& segment : table.cushions) walls.push_back(wall_of(segment));
    posts.reserve(table.jaws.size() + 2 * table.cushions.size());
    for (const model::JawArc& jaw : table.jaws) {
        posts.push_back(post_at(jaw.center_m, jaw.radius_m));
    }
    for (const model::CushionSegment& segment : table.cushions) {
        for (const Vec2& end : {segment.from_m, segment.to_m}) {
            if (!has_post(posts, end)) posts.push_back(post_at(end, 0.0));
            cushions.include(end);
        }
    }
    for (const model::PocketCircle& circle : table.pockets)
        pockets.push_back(pocket_of(circle, table.jaws));
    has_marks = table.half_playing_m != Vec2{};
    if (has_marks) {
        cushions = {table.center_m - table.half_playing_m, table.center_m + table.half_playing_m};
    }
    has_edge = table.half_outer_m != Vec2{};
    edge = {table.center_m - table.half_outer_m, table.center_m + table.half_outer_m};
    find_calm(largest_radius_m);
}

/// The playing surface a radius inside the noses, where nothing stands within.
void TableShape::find_calm(double largest_radius_m) {
    constexpr double kSlack_m = 1e-6;
    const Box inside = cushions.grown(-largest_radius_m - kSlack_m);
    const Box free = cushions.grown(-kSlack_m);
    const auto is_near_wall = [&](const Wall& wall) { return are_near(wall.box, free, 0.0); };
    const auto is_near_post = [&](const Post& post) {
        return are_near(post.box, free, post.radius_m);
    };
    const auto is_near_pocket = [&](const Pocket& pocket) {
        const Vec2 offset = pocket.center_m - glm::clamp(pocket.center_m, inside.low, inside.high);
        return glm::dot(offset, offset) <= pocket.radius_m * pocket.radius_m;
    };
    const bool is_free = inside.low.x < inside.high.x && inside.low.y < inside.high.y &&
                         std::none_of(walls.begin(), walls.end(), is_near_wall) &&
                         std::none_of(posts.begin(), posts.end(), is_near_post) &&
                         std::none_of(pockets.begin(), pockets.end(), is_near_pocket);
    if (is_free) calm = inside;
}

bool is_at_end(const Post& post, const Vec2& end) {
    constexpr double kSlack_m = 1e-6;
    return std::abs(length_of(end - post.center_m) - post.radius_m) <= kSlack_m;
}

bool is_behind_nose(const TableShape& shape, const Vec2& point) {
    constexpr double kSlack_m = 1e-9;
    if (!shape.has_marks || shape.cushions.contains(point)) return false;
    const auto is_behind = [&](const Wall& wall) {
        const auto lies_on = [&](int axis, double border) {
            return std::abs(wall.box.low[axis] - border) <= kSlack_m &&
                   std::abs(wall.box.high[axis] - border) <= kSlack_m;
        };
        for (int axis = 0; axis < 2; ++axis) {
            const double low = shape.cushions.low[axis];
            const double high = shape.cushions.high[axis];
            if (point[axis] < low && lies_on(axis, low)) return faces(wall, point);
            if (point[axis] > high && lies_on(axis, high)) return faces(wall, point);
        }
        return false;
    };
    const auto is_in_mouth = [&](const Pocket& pocket) {
        return length_of(point - pocket.center_m) <= pocket.mouth_m;
    };
    return std::any_of(shape.walls.begin(), shape.walls.end(), is_behind) ||
           std::none_of(shape.pockets.begin(), shape.pockets.end(), is_in_mouth);
}

}  // namespace billiards::physics
