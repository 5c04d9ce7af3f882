// Takes a layout; gives straight pots by plain geometry, no engine.
#include "common/bot/candidates.h"

#include "common/base/elementary.h"

#include <algorithm>
#include <cmath>

namespace billiards::bot {

namespace {

using base::Vec2;
using model::Layout;
using model::PlacedBall;
using model::TableSpec;

constexpr double kRadius_m = model::BallSpec{}.radius_m;
/// Thinner cuts than 78 degrees are luck.
constexpr double kMinCutCosine = 0.2;
/// How far from the object ball the cue ball is set down for a straight pot.
constexpr double kStraightIn_m[] = {0.15, 0.3, 0.6};

/// The way into a pocket.
struct Mouth {
    Vec2 middle_m;
    Vec2 drop_m;   ///< The middle of the pocket.
    Vec2 inwards;  ///< Unit vector into the pocket.
    double half_width_m;
};

/// The named tables' pockets are as wide as their mouths. A side pocket's mouth lies on the nose
/// line, a corner's across the corner.
Mouth mouth_of(const TableSpec& table, const model::PocketCircle& pocket) {
    const Vec2 corner_m = glm::clamp(pocket.center_m, -table.half_playing_m, table.half_playing_m);
    const Vec2 inwards = glm::normalize(pocket.center_m - corner_m);
    const bool is_corner = corner_m.x != pocket.center_m.x;
    const Vec2 middle_m = is_corner ? corner_m - pocket.radius_m * inwards : corner_m;
    return {middle_m, pocket.center_m, inwards, pocket.radius_m};
}

/// Where a ball from there is sent: a ball that hangs in the mouth already, straight on.
Vec2 target_m(const Mouth& mouth, Vec2 from_m) {
    const bool hangs = glm::dot(mouth.middle_m - from_m, mouth.inwards) < kRadius_m;
    return hangs ? mouth.drop_m : mouth.middle_m;
}

double distance_to_segment(Vec2 point, Vec2 from, Vec2 to) {
    const Vec2 along = to - from;
    const double square = glm::dot(along, along);
    const double part = square > 0 ? glm::dot(point - from, along) / square : 0.0;
    return glm::distance(point, from + std::clamp(part, 0.0, 1.0) * along);
}

bool is_inside(const TableSpec& table, Vec2 position_m) {
    const Vec2 reach_m = table.half_playing_m - kRadius_m;
    return std::fabs(position_m.x) <= reach_m.x && std::fabs(position_m.y) <= reach_m.y;
}

Vec2 ghost_m(const Pot& pot) {
    return pot.ball_m - 2 * kRadius_m * pot.towards;
}

/// One object ball on its way into one pocket, wherever the cue ball comes from.
struct Line {
    Pot pot;
    double clearance_m;  ///< On each side of the ball, in the mouth.
};

std::vector<Line> open_lines(const TableSpec& table, const Layout& layout, const PlacedBall& ball) {
    std::vector<Line> lines;
    for (std::uint8_t number = 0; number < table.pockets.size(); ++number) {
        const Mouth mouth = mouth_of(table, table.pockets[number]);
        const Vec2 end_m = target_m(mouth, ball.position_m);
        const Vec2 path_m = end_m - ball.position_m;
        const double length_m = std::max(glm::length(path_m), kRadius_m);
        const Vec2 towards = path_m / length_m;
        const double seen_m = mouth.half_width_m * glm::dot(towards, mouth.inwards);
        if (seen_m <= kRadius_m) continue;
        if (!is_path_clear(layout, ball.position_m, end_m, ball.ball)) continue;
        Pot pot;
        pot.ball = ball.ball;
        pot.pocket = {number};
        pot.ball_m = ball.position_m;
        pot.towards = towards;
        pot.ball_path_m = length_m;
        lines.push_back({pot, seen_m - kRadius_m});
    }
    return lines;
}

std::vector<Line> open_lines(const TableSpec& table, const Layout& layout, model::BallSet targets) {
    std::vector<Line> lines;
    for (const PlacedBall& placed : layout.balls) {
        const bool counts = placed.place == model::Place::OnTable && targets.contains(placed.ball);
        if (!counts) continue;
        const std::vector<Line> more = open_lines(table, layout, placed);
        lines.insert(lines.end(), more.begin(), more.end());
    }
    return lines;
}

/// Fills in what depends on the cue ball; false where the pot cannot be played from there.
bool is_playable_from(const TableSpec& table, const Layout& layout, Vec2 cue_ball_m, Line& line) {
    Pot& pot = line.pot;
    const Vec2 end_m = ghost_m(pot);
    const Vec2 path_m = end_m - cue_ball_m;
    pot.cue_path_m = std::max(glm::length(path_m), kRadius_m);
    pot.cut_cosine = glm::dot(path_m, pot.towards) / pot.cue_path_m;
    if (pot.cut_cosine < kMinCutCosine || !is_inside(table, end_m)) return false;
    // An error of the aim grows by cue path over (diameter x cosine) at the contact, and the
    // object ball carries it all the way to the mouth.
    pot.margin_rad =
        line.clearance_m / pot.ball_path_m * 2 * kRadius_m * pot.cut_cosine / pot.cue_path_m;
    return is_path_clear(layout, cue_ball_m, end_m, pot.ball);
}

}  // namespace

bool is_path_clear(const Layout& layout, Vec2 from_m, Vec2 to_m, model::BallId except) {
    constexpr double kClear_m = 2 * kRadius_m - 1e-9;
    return std::ranges::none_of(layout.balls, [&](const PlacedBall& placed) {
        const bool in_play = placed.place == model::Place::OnTable &&
                             placed.ball != model::kCueBall && placed.ball != except;
        return in_play && distance_to_segment(placed.position_m, from_m, to_m) < kClear_m;
    });
}

double aim_rad(Vec2 cue_ball_m, const Pot& pot) {
    const Vec2 path_m = ghost_m(pot) - cue_ball_m;
    return base::arc_tangent(path_m.y, path_m.x);
}

std::vector<Pot> pots_from(const TableSpec& table, const Layout& layout, model::BallSet targets,
                           Vec2 cue_ball_m) {
    std::vector<Pot> pots;
    for (Line& line : open_lines(table, layout, targets)) {
        if (is_playable_from(table, layout, cue_ball_m, line)) pots.push_back(line.pot);
    }
    std::ranges::stable_sort(pots, std::ranges::greater{}, &Pot::margin_rad);
    return pots;
}

std::vector<Vec2> straight_in_places(const TableSpec& table, const Layout& layout,
                                     model::BallSet targets) {
    std::vector<Vec2> places_m;
    for (const Line& line : open_lines(table, layout, targets)) {
        for (const double distance_m : kStraightIn_m) {
            places_m.push_back(line.pot.ball_m - (2 * kRadius_m + distance_m) * line.pot.towards);
        }
    }
    return places_m;
}

}  // namespace billiards::bot
