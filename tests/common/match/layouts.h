// Gives layouts told ball by ball, and random ones without overlaps.
#pragma once

#include "common/base/random.h"
#include "common/model/layout.h"
#include "common/model/table_spec.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace billiards::match {

inline constexpr double kRadius_m = model::BallSpec{}.radius_m;

inline const model::TableSpec& nine_foot() {
    return model::table_of(model::TableSize::NineFoot);
}

inline model::BallId id(int ball) {
    return {static_cast<std::uint8_t>(ball)};
}

/// In ascending number; all on the table.
inline model::Layout layout_of(const std::vector<std::pair<int, base::Vec2>>& balls) {
    model::Layout layout;
    for (const auto& [ball, position_m] : balls) {
        layout.balls.push_back({id(ball), model::Place::OnTable, position_m});
    }
    return layout;
}

/// Fifteen object balls anywhere inside the cushions.
inline model::Layout random_layout(std::uint64_t seed) {
    base::Random random(seed);
    const base::Vec2 reach_m = nine_foot().half_playing_m - kRadius_m;
    model::Layout layout;
    while (layout.balls.size() < 15) {
        const base::Vec2 place_m{random.uniform(-reach_m.x, reach_m.x),
                                 random.uniform(-reach_m.y, reach_m.y)};
        const bool overlaps = std::ranges::any_of(layout.balls, [&](const auto& placed) {
            return glm::distance(placed.position_m, place_m) < 2 * kRadius_m;
        });
        const int ball = static_cast<int>(layout.balls.size()) + 1;
        if (!overlaps) layout.balls.push_back({id(ball), model::Place::OnTable, place_m});
    }
    return layout;
}

}  // namespace billiards::match
