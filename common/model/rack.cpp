// Takes a table and a ball's size; gives the frozen triangle.
#include "common/model/rack.h"

#include <cmath>

namespace billiards::model {

std::vector<base::Vec2> triangle_positions(const TableSpec& table, double radius_m) {
    const base::Vec2 apex = foot_spot(table);
    const double row_distance = std::sqrt(3.0) * radius_m;
    std::vector<base::Vec2> positions;
    positions.reserve(15);
    for (int row = 0; row < 5; ++row) {
        for (int place = 0; place <= row; ++place) {
            // From the middle outwards, so that the rack is its own mirror image to the bit.
            positions.push_back({apex.x + row * row_distance, (2 * place - row) * radius_m});
        }
    }
    return positions;
}

}  // namespace billiards::model
