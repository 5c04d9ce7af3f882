// Takes how a ball entered its pocket; gives a free fall between the pocket's walls.
#include "client/scene/falling.h"

#include "common/timeline/evaluate.h"

#include <algorithm>
#include <optional>

namespace billiards::client {

namespace {

constexpr double kGravity_mps2 = 9.81;
/// In this time the slate's edge has let the ball past.
constexpr double kOverEdge_s = 0.05;
constexpr double kOutOfSight_m = -0.12;  ///< The drawn pockets are 0.09 m deep.

const model::PocketCircle* nearest_pocket(const model::TableSpec& table, const base::Vec2& place) {
    const auto nearest = std::min_element(
        table.pockets.begin(), table.pockets.end(), [&](const auto& a, const auto& b) {
            return glm::distance(a.center_m, place) < glm::distance(b.center_m, place);
        });
    return nearest == table.pockets.end() ? nullptr : &*nearest;
}

base::Vec2 held_within(const base::Vec2& place, const base::Vec2& center, double reach_m) {
    const base::Vec2 off = place - center;
    const double distance = glm::length(off);
    return distance > reach_m ? center + off * (reach_m / distance) : place;
}

std::optional<base::Vec3> falling_at(const timeline::BallTrack& track,
                                     const model::TableSpec& table, double time_s) {
    const timeline::Segment& last = track.segments.back();
    if (last.motion != model::Motion::Pocketed || track.segments.size() < 2 ||
        time_s < last.start_s) {
        return std::nullopt;
    }
    const timeline::Segment& before = *(track.segments.end() - 2);
    const model::BallState entry = timeline::evaluate(before, last.start_s);
    const model::PocketCircle* pocket = nearest_pocket(table, base::horizontal(entry.position_m));
    if (pocket == nullptr) return std::nullopt;

    const double fallen_s = time_s - last.start_s;
    base::Vec3 place = entry.position_m + entry.velocity_mps * fallen_s;
    place.z -= kGravity_mps2 / 2 * fallen_s * fallen_s;
    if (place.z < kOutOfSight_m) return std::nullopt;
    const double inset = track.radius_m * std::min(1.0, fallen_s / kOverEdge_s);
    const base::Vec2 held = held_within(base::horizontal(place), pocket->center_m,
                                        std::max(0.0, pocket->radius_m - inset));
    return base::Vec3(held, place.z);
}

}  // namespace

std::vector<ShownBall> falling_balls(const timeline::Timeline& timeline,
                                     const model::TableSpec& table, double time_s) {
    std::vector<ShownBall> falling;
    for (const timeline::BallTrack& track : timeline.tracks) {
        if (const auto place = falling_at(track, table, time_s)) {
            falling.push_back({.ball = track.ball,
                               .radius_m = track.radius_m,
                               .state = {.position_m = *place, .motion = model::Motion::Pocketed}});
        }
    }
    return falling;
}

}  // namespace billiards::client
