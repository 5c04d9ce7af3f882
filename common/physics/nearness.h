// Takes a ball's place and a table; gives how near its cushions and jaws are.
#pragma once

#include "common/base/vec.h"
#include "common/physics/table_shape.h"

#include <cstdint>
#include <vector>

namespace billiards::physics {

/// A wall or a post, in one numbering: walls first.
using FixedIndex = std::uint16_t;

inline FixedIndex wall_index(int wall) {
    return static_cast<FixedIndex>(wall);
}
inline FixedIndex post_index(const TableShape& shape, int post) {
    return static_cast<FixedIndex>(shape.walls.size() + static_cast<std::size_t>(post));
}
inline bool is_post(const TableShape& shape, FixedIndex fixed) {
    return fixed >= shape.walls.size();
}

/// How far a ball's surface is from a wall's line or from a post, and where that lies.
struct Nearness {
    double gap_m = 0.0;
    base::Vec2 into{};       ///< Horizontal unit vector from the ball's centre to it.
    double lean_sine = 0.0;  ///< Height of the nose above the centre, in radii.
};

/// A ball above the slate meets a wall's nose by its true height; a post is an upright cylinder.
Nearness nearness(const TableShape& shape, FixedIndex fixed, const base::Vec3& position_m,
                  double radius_m);

/// Whether they are parts of one cushion: a wall, and the post that an end of it runs into.
bool adjoin(const TableShape& shape, FixedIndex a, FixedIndex b);

/// Adds every wall that faces the ball, and every post, within kTouching_m.
void add_touching(const TableShape& shape, const base::Vec3& position_m, double radius_m,
                  std::vector<FixedIndex>& touching);

}  // namespace billiards::physics
