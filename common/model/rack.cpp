// Takes a table and a ball's size; gives the frozen triangle and the frozen diamond.
#include "common/model/rack.h"

#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace billiards::model {

namespace {

/// Row by row away from the head; `first_row` says how many rows past the foot spot the first is.
std::vector<base::Vec2> row_positions(const TableSpec& table, double radius_m,
                                      std::span<const int> balls_in_row, int first_row) {
    const base::Vec2 spot = foot_spot(table);
    const double row_distance = std::sqrt(3.0) * radius_m;
    std::vector<base::Vec2> positions;
    int row = first_row;
    for (const int balls : balls_in_row) {
        for (int place = 0; place < balls; ++place) {
            // From the middle outwards, so that the rack is its own mirror image to the bit.
            positions.push_back(
                {spot.x + row * row_distance, spot.y + (2 * place - (balls - 1)) * radius_m});
        }
        ++row;
    }
    return positions;
}

}  // namespace

std::vector<base::Vec2> triangle_positions(const TableSpec& table, double radius_m, int rows) {
    std::vector<int> balls_in_row(static_cast<std::size_t>(rows));
    std::iota(balls_in_row.begin(), balls_in_row.end(), 1);
    return row_positions(table, radius_m, balls_in_row, 0);
}

std::vector<base::Vec2> diamond_positions(const TableSpec& table, double radius_m,
                                          OnFootSpot on_foot_spot) {
    static constexpr std::array<int, 5> kBallsInRow{1, 2, 3, 2, 1};
    const int first_row = on_foot_spot == OnFootSpot::Apex ? 0 : -2;
    return row_positions(table, radius_m, kBallsInRow, first_row);
}

}  // namespace billiards::model
