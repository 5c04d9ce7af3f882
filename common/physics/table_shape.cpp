// Takes a table as data; gives its walls, posts, pockets and edge.
#include "common/physics/table_shape.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec2;

/// An arc belongs to a segment's end that its circle passes this near (table_spec.h).
constexpr double kArcSlack_m = 1e-6;

Wall wall_of(const model::CushionSegment& segment) {
    Wall wall{.from_m = segment.from_m};
    const Vec2 span = segment.to_m - segment.from_m;
    wall.length_m = std::sqrt(span.x * span.x + span.y * span.y);
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

Pocket pocket_of(const model::PocketCircle& circle) {
    Pocket pocket{.center_m = circle.center_m, .radius_m = circle.radius_m};
    pocket.box.include(circle.center_m);
    return pocket;
}

bool has_post(const std::vector<Post>& posts, const Vec2& end) {
    return std::any_of(posts.begin(), posts.end(), [&](const Post& post) {
        const Vec2 offset = end - post.center_m;
        const double distance = std::sqrt(offset.x * offset.x + offset.y * offset.y);
        return std::abs(distance - post.radius_m) <= kArcSlack_m;
    });
}

}  // namespace

TableShape::TableShape(const model::TableSpec& table) : nose_height_m(table.nose_height_m) {
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
    for (const model::PocketCircle& circle : table.pockets) pockets.push_back(pocket_of(circle));
    if (table.half_playing_m != Vec2{}) {
        cushions = {table.center_m - table.half_playing_m, table.center_m + table.half_playing_m};
    }
    has_edge = table.half_outer_m != Vec2{};
    edge = {table.center_m - table.half_outer_m, table.center_m + table.half_outer_m};
}

}  // namespace billiards::physics
