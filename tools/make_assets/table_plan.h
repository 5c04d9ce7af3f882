// Takes a table as the physics has it; gives its outlines seen from above, for the drawn one.
#pragma once

#include "common/model/table_spec.h"

#include <vector>

namespace billiards::make_assets {

/// A place on an outline, and the unit normal of the edge there, pointing away from what is seen.
struct EdgePoint {
    base::Vec2 place_m{};
    base::Vec2 normal{};
};
using Edge = std::vector<EdgePoint>;

/// One cushion and the board behind it, between two pockets, seen from the table's middle.
struct RailPlan {
    base::Vec2 along{};    ///< Unit vector, anticlockwise round the table.
    base::Vec2 into{};     ///< Unit vector from the nose into the rail.
    double back_m = 0.0;   ///< Of the rubber's back from the origin, along `into`.
    double width_m = 0.0;  ///< Of the rubber, from the nose to its back.
    Edge nose;             ///< Facing, jaw, nose, jaw, facing; normals point into the rubber.
    Edge outer;            ///< The board's outer edge, between the cuts; normals point outwards.
    std::vector<base::Vec2> inner;  ///< The board's inner edge: cut, pocket, back, pocket, cut.
};

/// One pocket's hole, and where cloth and wood end at it. Arcs are anticlockwise.
struct PocketPlan {
    model::PocketCircle hole;
    std::vector<double> wood_arc_rad;   ///< Directions in which wood surrounds the hole.
    std::vector<double> cloth_arc_rad;  ///< Directions in which the bed does.
    double wood_m = 0.0;  ///< From the hole to the boards' edge where that is nearest.
};

/// Rail i lies between the pockets i and i + 1 (mod 6).
struct TablePlan {
    std::vector<RailPlan> rails;
    std::vector<PocketPlan> pockets;
    std::vector<base::Vec2> bed;     ///< Outline of the cloth, up to the rubber's backs.
    std::vector<base::Vec2> sights;  ///< Rail by rail, three each.
    double nose_height_m = 0.0;
    double top_height_m = 0.0;  ///< Of the wood.
};

/// How much wider than the hole the opening in the wood is: the liner's thickness.
inline constexpr double kLiner_m = 0.004;
/// Radius of the boards' upper edge.
inline constexpr double kRounding_m = 0.005;

/// Of one of the three named tables.
TablePlan plan_of(const model::TableSpec& table);

}  // namespace billiards::make_assets
