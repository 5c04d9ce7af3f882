// Takes a layout and a wish; gives where a ball may lie. Every place that is "as near as can be" to
// another lies there or touches a ball that is in the way, so those are the only ones looked at.
#include "common/match/placement.h"

#include "common/base/check.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

namespace billiards::match {

namespace {

using base::Vec2;
using model::kCueBall;

constexpr double kRadius_m = model::BallSpec{}.radius_m;
/// A gap or an overlap below this is touching: the same as in the engine.
constexpr double kTouching_m = 1e-12;
/// WPA 1.5: between a spotted ball and the cue ball "a small separation must be maintained".
constexpr double kCueBallGap_m = 1e-4;
/// How far behind the head string a ball is set that should lie at it.
constexpr double kBehindLine_m = 1e-3;

/// A ball that another centre must not come nearer to than distance_m.
struct Obstacle {
    Vec2 center_m;
    double distance_m;
};

std::vector<Obstacle> balls_but(model::BallId ball, const model::Layout& layout) {
    std::vector<Obstacle> obstacles;
    for (const model::PlacedBall& placed : layout.balls) {
        if (placed.ball == ball || placed.place != model::Place::OnTable) continue;
        obstacles.push_back({placed.position_m, 2 * kRadius_m});
    }
    return obstacles;
}

bool is_free(std::span<const Obstacle> obstacles, Vec2 position_m) {
    return std::ranges::all_of(obstacles, [&](const Obstacle& obstacle) {
        const double distance_m = glm::distance(obstacle.center_m, position_m);
        return distance_m >= obstacle.distance_m - kTouching_m;
    });
}

/// Nearest to `from_m`, between it and `to_m`, both on the same line along x; none where the whole
/// of it is blocked.
std::optional<Vec2> nearest_free(std::span<const Obstacle> obstacles, Vec2 from_m, double to_x_m) {
    std::vector<double> candidates_m{from_m.x};
    for (const auto& [center_m, distance_m] : obstacles) {
        const double across_m = center_m.y - from_m.y;
        const double square_m2 = distance_m * distance_m - across_m * across_m;
        if (square_m2 <= 0) continue;
        candidates_m.push_back(center_m.x - std::sqrt(square_m2));
        candidates_m.push_back(center_m.x + std::sqrt(square_m2));
    }
    const auto [low_m, high_m] = std::minmax(from_m.x, to_x_m);
    std::optional<Vec2> nearest;
    for (const double x_m : candidates_m) {
        const Vec2 place_m{x_m, from_m.y};
        if (x_m < low_m || x_m > high_m || !is_free(obstacles, place_m)) continue;
        const bool nearer =
            !nearest || std::fabs(x_m - from_m.x) < std::fabs(nearest->x - from_m.x);
        if (nearer) nearest = place_m;
    }
    return nearest;
}

/// How far a centre may be from the table's.
Vec2 reach(const model::TableSpec& table) {
    return table.half_playing_m - kRadius_m;
}

Refusal bad_placement(Vec2 position_m, const std::string& why) {
    return {RefusalCode::BadPlacement,
            fmt::format("({:.6g}, {:.6g}) m {}", position_m.x, position_m.y, why)};
}

bool is_inside_cushions(const model::TableSpec& table, Vec2 position_m) {
    const Vec2 limit_m = reach(table) + kTouching_m;
    // Written so that a NaN is outside.
    return std::fabs(position_m.x) <= limit_m.x && std::fabs(position_m.y) <= limit_m.y;
}

bool is_over_pocket(const model::TableSpec& table, Vec2 position_m) {
    return std::ranges::any_of(table.pockets, [&](const model::PocketCircle& pocket) {
        return glm::distance(pocket.center_m, position_m) < pocket.radius_m;
    });
}

std::optional<Vec2> free_on_line(const model::TableSpec& table, std::span<const Obstacle> obstacles,
                                 rules::Zone zone, double y_m) {
    const double head_m = -reach(table).x;
    if (zone == rules::Zone::BehindHeadString && table.head_string_m) {
        return nearest_free(obstacles, {*table.head_string_m - kBehindLine_m, y_m}, head_m);
    }
    const Vec2 from_m{model::head_spot(table).x, y_m};
    const std::optional<Vec2> behind = nearest_free(obstacles, from_m, head_m);
    const std::optional<Vec2> before = nearest_free(obstacles, from_m, -head_m);
    if (!behind || !before) return behind ? behind : before;
    return from_m.x - behind->x <= before->x - from_m.x ? behind : before;
}

void spot_ball(const model::TableSpec& table, model::Layout& layout, model::BallId ball) {
    model::PlacedBall* spotted = layout.find(ball);
    CHECK(spotted != nullptr && spotted->place != model::Place::OnTable);
    std::vector<Obstacle> obstacles = balls_but(kCueBall, layout);
    if (layout.on_table(kCueBall)) {
        obstacles.push_back({layout.find(kCueBall)->position_m, 2 * kRadius_m + kCueBallGap_m});
    }
    const Vec2 spot_m = model::foot_spot(table);
    std::optional<Vec2> place_m = nearest_free(obstacles, spot_m, reach(table).x);
    if (!place_m) place_m = nearest_free(obstacles, spot_m, -reach(table).x);
    CHECK(place_m.has_value());  // A set of balls is too few to block the long string.
    spotted->place = model::Place::OnTable;
    spotted->position_m = *place_m;
}

}  // namespace

Result<base::Done> check_placement(const model::TableSpec& table, const model::Layout& layout,
                                   rules::Zone zone, Vec2 position_m, model::BallId ball) {
    if (!is_inside_cushions(table, position_m)) {
        return bad_placement(position_m, "is not inside the cushions");
    }
    if (is_over_pocket(table, position_m)) return bad_placement(position_m, "is over a pocket");
    const bool must_be_behind = zone == rules::Zone::BehindHeadString && table.head_string_m;
    if (must_be_behind && position_m.x >= *table.head_string_m) {
        return bad_placement(position_m, "is not behind the head string");
    }
    if (!is_free(balls_but(ball, layout), position_m)) {
        return bad_placement(position_m, "overlaps another ball");
    }
    return base::Done{};
}

Vec2 default_placement(const model::TableSpec& table, const model::Layout& layout,
                       rules::Zone zone) {
    const std::vector<Obstacle> obstacles = balls_but(kCueBall, layout);
    // The long string, or where all of it is blocked the nearest line beside it.
    for (double aside_m = 0.0; aside_m <= reach(table).y; aside_m += kRadius_m) {
        for (const double y_m : {aside_m, -aside_m}) {
            const std::optional<Vec2> place_m = free_on_line(table, obstacles, zone, y_m);
            if (place_m) return *place_m;
        }
    }
    CHECK(false);  // A set of balls is too few to fill the zone.
}

void spot_balls(const model::TableSpec& table, model::Layout& layout,
                std::span<const model::BallId> balls) {
    std::vector<model::BallId> ascending(balls.begin(), balls.end());
    std::ranges::sort(ascending);
    for (const model::BallId ball : ascending) spot_ball(table, layout, ball);
}

void spot_nearest(const model::TableSpec& table, model::Layout& layout, model::BallSet balls) {
    model::PlacedBall* nearest = nullptr;
    balls.for_each([&](model::BallId ball) {
        model::PlacedBall* placed = layout.find(ball);
        CHECK(placed != nullptr && placed->place == model::Place::OnTable);
        if (!nearest || placed->position_m.x > nearest->position_m.x) nearest = placed;
    });
    CHECK(nearest != nullptr);
    nearest->place = model::Place::InHand;
    spot_ball(table, layout, nearest->ball);
}

model::BallSet balls_behind_head_string(const model::TableSpec& table,
                                        const model::Layout& layout) {
    model::BallSet behind;
    for (const model::PlacedBall& placed : layout.balls) {
        const bool counts = placed.ball != kCueBall && placed.place == model::Place::OnTable;
        if (counts && table.head_string_m && placed.position_m.x < *table.head_string_m) {
            behind.insert(placed.ball);
        }
    }
    return behind;
}

}  // namespace billiards::match
