// Takes a table and a ball's size; gives the places of a rack's balls. Neighbours touch to within
// 1e-12 m. Places are in order row by row away from the head, each row from -y to +y.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"
#include "common/model/table_spec.h"

#include <cstddef>
#include <vector>

namespace billiards::model {

/// The place in the middle of a rack: of the third row of every triangle and of the diamond.
inline constexpr std::size_t kMiddlePlace = 4;

/// A triangle with its apex on the foot spot: five rows are the fifteen balls of a set.
std::vector<base::Vec2> triangle_positions(const TableSpec& table, double radius_m, int rows = 5);

enum class OnFootSpot { Apex, Middle };

/// The nine places of a diamond.
std::vector<base::Vec2> diamond_positions(const TableSpec& table, double radius_m,
                                          OnFootSpot on_foot_spot = OnFootSpot::Apex);

}  // namespace billiards::model
