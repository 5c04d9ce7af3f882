// Takes a layout of straight pool; gives it racked, with the cue ball and the fifteenth ball where
// the rules want them.
#include "common/match/rerack.h"

#include "common/base/check.h"
#include "common/match/placement.h"
#include "common/model/rack.h"
#include "common/rules/racking.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace billiards::match {

namespace {

using base::Vec2;
using model::BallId;
using model::Place;
using model::PlacedBall;
using rules::Rerack;
using rules::Zone;

constexpr double kRadius_m = model::BallSpec{}.radius_m;
/// A gap or an overlap below this is touching: the same as in the engine.
constexpr double kTouching_m = 1e-12;
constexpr Vec2 kCentreSpot_m{0.0, 0.0};

/// Counterclockwise.
std::array<Vec2, 3> outline_of_rack(const model::TableSpec& table) {
    const std::vector<Vec2> places_m = model::triangle_positions(table, kRadius_m);
    std::array<Vec2, 3> corners_m{places_m[0], places_m[10], places_m[14]};
    const Vec2 middle_m = (corners_m[0] + corners_m[1] + corners_m[2]) / 3.0;
    // A side that is one radius further out meets the next one two radii further out.
    for (Vec2& corner_m : corners_m) {
        corner_m += 2 * kRadius_m * glm::normalize(corner_m - middle_m);
    }
    return corners_m;
}

double distance_to_side(Vec2 from_m, Vec2 to_m, Vec2 position_m) {
    const Vec2 side_m = to_m - from_m;
    const double along = glm::dot(position_m - from_m, side_m) / glm::dot(side_m, side_m);
    return glm::distance(position_m, from_m + std::clamp(along, 0.0, 1.0) * side_m);
}

bool is_left_of(Vec2 from_m, Vec2 to_m, Vec2 position_m) {
    const Vec2 side_m = to_m - from_m;
    const Vec2 offset_m = position_m - from_m;
    return side_m.x * offset_m.y - side_m.y * offset_m.x > 0;
}

/// The places, from the given one on, filled with `balls` in random order.
void rack_balls(const model::TableSpec& table, model::Layout& layout, std::vector<BallId> balls,
                std::size_t first_place, base::Random& random) {
    const std::vector<Vec2> places_m = model::triangle_positions(table, kRadius_m);
    CHECK(first_place + balls.size() == places_m.size());
    rules::shuffle(balls, random);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        *layout.find(balls[i]) = {balls[i], Place::OnTable, places_m[first_place + i]};
    }
}

Vec2 head_spot_or_centre(const model::TableSpec& table, Vec2 other_ball_m) {
    const Vec2 head_spot_m = model::head_spot(table);
    const bool blocked = glm::distance(head_spot_m, other_ball_m) < 2 * kRadius_m;
    return blocked ? kCentreSpot_m : head_spot_m;
}

Zone in_hand_behind_head_string(PlacedBall& cue_ball) {
    cue_ball = {model::kCueBall, Place::InHand, {}};
    return Zone::BehindHeadString;
}

std::vector<BallId> object_balls(const model::Layout& layout, auto&& wanted) {
    std::vector<BallId> balls;
    for (const PlacedBall& placed : layout.balls) {
        if (placed.ball != model::kCueBall && wanted(placed)) balls.push_back(placed.ball);
    }
    return balls;
}

bool is_up(const PlacedBall& placed) {
    return placed.place == Place::OnTable;
}

Zone rack_fifteen(const model::TableSpec& table, model::Layout& layout, base::Random& random) {
    PlacedBall& cue_ball = *layout.find(model::kCueBall);
    const auto every = [](const PlacedBall&) { return true; };
    rack_balls(table, layout, object_balls(layout, every), 0, random);
    const bool in_the_way = is_up(cue_ball) && is_in_rack(table, cue_ball.position_m);
    return in_the_way ? in_hand_behind_head_string(cue_ball) : Zone::None;
}

}  // namespace

bool is_in_rack(const model::TableSpec& table, Vec2 position_m) {
    const auto [apex, right, left] = outline_of_rack(table);
    const bool inside = is_left_of(apex, right, position_m) &&
                        is_left_of(right, left, position_m) && is_left_of(left, apex, position_m);
    const double to_side_m = std::min({distance_to_side(apex, right, position_m),
                                       distance_to_side(right, left, position_m),
                                       distance_to_side(left, apex, position_m)});
    return inside || to_side_m <= kRadius_m + kTouching_m;
}

Zone rerack(const model::TableSpec& table, model::Layout& layout, Rerack which,
            base::Random& random) {
    CHECK(which != Rerack::None);
    if (which == Rerack::Fifteen) return rack_fifteen(table, layout, random);

    const std::vector<BallId> up = object_balls(layout, is_up);
    CHECK(up.size() == 1);
    PlacedBall& fifteenth = *layout.find(up.front());
    PlacedBall& cue_ball = *layout.find(model::kCueBall);
    const bool fifteenth_in_rack = is_in_rack(table, fifteenth.position_m);
    const bool cue_ball_in_rack = is_up(cue_ball) && is_in_rack(table, cue_ball.position_m);
    if (fifteenth_in_rack && cue_ball_in_rack) return rack_fifteen(table, layout, random);

    const bool behind_head_string =
        balls_behind_head_string(table, layout).contains(fifteenth.ball);
    rack_balls(table, layout, object_balls(layout, std::not_fn(is_up)), 1, random);
    if (fifteenth_in_rack) {
        fifteenth.position_m = head_spot_or_centre(table, cue_ball.position_m);
    } else if (cue_ball_in_rack && !behind_head_string) {
        return in_hand_behind_head_string(cue_ball);
    } else if (cue_ball_in_rack) {
        cue_ball.position_m = head_spot_or_centre(table, fifteenth.position_m);
    }
    return Zone::None;
}

}  // namespace billiards::match
