// Takes the name of a kind of shot; gives such shots.
#include "tools/sim/bench_shots.h"

#include "common/base/elementary.h"
#include "common/model/rack.h"
#include "common/physics/parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace billiards::tools {

using model::BallId;
using model::Layout;

namespace {

constexpr double kMidSpeed_mps = 3.0;
constexpr int kMidBalls = 9;

}  // namespace

const model::TableSpec& BenchShots::table() const {
    return model::table_of(case_ == BenchCase::Break9 ? model::TableSize::NineFoot
                                                      : model::TableSize::EightFoot);
}

BenchShot BenchShots::hard_break() {
    BenchShot start{.layout = rack(), .shot = {}};
    start.shot.power = random_.uniform(0.7, 1.0);
    start.shot.angle_rad = base::radians(random_.uniform(-1.0, 1.0));
    constexpr double kOffset = 0.2;
    do {
        start.shot.tip_left = random_.uniform(-kOffset, kOffset);
        start.shot.tip_up = random_.uniform(-kOffset, kOffset);
    } while (std::hypot(start.shot.tip_left, start.shot.tip_up) > kOffset);
    return start;
}

Layout BenchShots::rack() const {
    const std::vector<base::Vec2> triangle =
        model::triangle_positions(table(), model::BallSpec{}.radius_m);
    // Rows of 1, 2, 3, 2, 1: the diamond within the triangle.
    static constexpr std::size_t kDiamond[] = {0, 1, 2, 3, 4, 5, 7, 8, 12};
    Layout layout{{{.ball = model::kCueBall, .position_m = model::head_spot(table())}}};
    for (std::size_t i = 0; i < triangle.size(); ++i) {
        const bool is_in_diamond = std::count(std::begin(kDiamond), std::end(kDiamond), i) > 0;
        if (case_ == BenchCase::Break9 && !is_in_diamond) continue;
        const auto number = static_cast<std::uint8_t>(layout.balls.size());
        layout.balls.push_back({.ball = BallId{number}, .position_m = triangle[i]});
    }
    return layout;
}

BenchShot BenchShots::mid() {
    const base::Vec2 reach = table().half_playing_m - 2.5 * model::BallSpec{}.radius_m;
    BenchShot start;
    while (start.layout.balls.size() < kMidBalls) {
        const base::Vec2 place{random_.uniform(-reach.x, reach.x),
                               random_.uniform(-reach.y, reach.y)};
        const bool is_free = std::all_of(
            start.layout.balls.begin(), start.layout.balls.end(), [&](const auto& other) {
                return glm::distance(other.position_m, place) > 2 * model::BallSpec{}.radius_m;
            });
        if (!is_free) continue;
        const auto number = static_cast<std::uint8_t>(start.layout.balls.size());
        start.layout.balls.push_back({.ball = BallId{number}, .position_m = place});
    }
    const physics::Parameters parameters;
    start.shot.power = kMidSpeed_mps * model::BallSpec{}.mass_kg /
                       (parameters.cue_spring_npm * parameters.cue_contact_time_s);
    start.shot.angle_rad = random_.uniform(-base::kPi, base::kPi);
    return start;
}

}  // namespace billiards::tools
