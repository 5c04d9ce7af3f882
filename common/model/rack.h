// Takes an order of balls; gives where the rack puts them.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"
#include "common/model/table_spec.h"

#include <span>
#include <vector>

namespace billiards::model {

/// Positions of a frozen triangle of five rows: the apex on the foot spot, then row by row away
/// from the head, each row from -y to +y. Neighbours touch to within 1e-12 m.
std::vector<base::Vec2> triangle_positions(const TableSpec& table, double radius_m);

}  // namespace billiards::model
