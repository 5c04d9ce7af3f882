// Takes a table as data; gives it as the engine meets it: walls, posts, pockets and an edge.
#pragma once

#include "common/base/vec.h"
#include "common/model/table_spec.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace billiards::physics {

/// An upright rectangle. Empty at first.
struct Box {
    base::Vec2 low{std::numeric_limits<double>::infinity()};
    base::Vec2 high{-std::numeric_limits<double>::infinity()};

    void include(const base::Vec2& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    Box grown(double margin) const { return {low - margin, high + margin}; }
    bool contains(const Box& other) const {
        return (other.low.x >= low.x) & (other.high.x <= high.x) & (other.low.y >= low.y) &
               (other.high.y <= high.y);
    }
    bool contains(const base::Vec2& point) const {
        return point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y;
    }
};

/// Whether two boxes are nearer than `reach` in both directions.
inline bool are_near(const Box& a, const Box& b, double reach) {
    return (a.low.x <= b.high.x + reach) & (b.low.x <= a.high.x + reach) &
           (a.low.y <= b.high.y + reach) & (b.low.y <= a.high.y + reach);
}

/// A cushion segment.
struct Wall {
    base::Vec2 from_m{};
    base::Vec2 along{};   ///< Unit vector from one end to the other.
    base::Vec2 normal{};  ///< A quarter turn of it.
    double length_m = 0.0;
    Box box{};
};

/// A jaw arc, or the bare end of a segment as an arc of radius 0.
struct Post {
    base::Vec2 center_m{};
    double radius_m = 0.0;
    Box box{};  ///< Of the centre alone.
};

struct Pocket {
    base::Vec2 center_m{};
    double radius_m = 0.0;
    double mouth_m = 0.0;  ///< From the centre to the nearest jaw: what is in its mouth is nearer.
    Box box{};
};

/// Walls, posts and pockets keep the order of the table's data: cushion i is walls[i], jaw i is
/// posts[i]; the bare ends follow the jaws, each place once, in the order of the segments.
struct TableShape {
    std::vector<Wall> walls;
    std::vector<Post> posts;
    std::vector<Pocket> pockets;
    double nose_height_m = 0.0;
    bool has_edge = false;
    Box edge;                ///< Beyond it a ball is off the table.
    bool has_marks = false;  ///< A table of known playing size, with a rail behind its noses.
    Box cushions;            ///< What the noses enclose.
    Box calm;                ///< A centre within it is near nothing fixed. May be empty.

    /// No ball's radius is above largest_radius_m.
    TableShape(const model::TableSpec& table, double largest_radius_m);

  private:
    void find_calm(double largest_radius_m);
};

/// Along the wall from its start, where the foot of the perpendicular from this point falls.
inline double foot_m(const Wall& wall, const base::Vec2& point) {
    return glm::dot(wall.along, point - wall.from_m);
}

/// Whether the post's circle passes through this end of a wall (table_spec.h).
bool is_at_end(const Post& post, const base::Vec2& end);

/// Whether the foot falls on the wall.
inline bool faces(const Wall& wall, const base::Vec2& point) {
    constexpr double kSlack_m = 1e-12;
    const double foot = foot_m(wall, point);
    return foot >= -kSlack_m && foot <= wall.length_m + kSlack_m;
}

/// Whether a centre lies past the playing surface, behind a nose or beyond a pocket's mouth. Only
/// where the table has marks.
bool is_behind_nose(const TableShape& shape, const base::Vec2& point);

}  // namespace billiards::physics
