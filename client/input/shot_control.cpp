// Takes hands; gives a shot whose numbers make sense.
#include "client/input/shot_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace billiards::client {

void ShotControl::aim_at(base::Vec2 cue_ball_m, base::Vec2 point_m) {
    const base::Vec2 way = point_m - cue_ball_m;
    if (way == base::Vec2{}) return;
    set_angle(std::atan2(way.y, way.x));
}

void ShotControl::set_angle(double angle_rad) {
    if (is_pulled() || !std::isfinite(angle_rad)) return;
    shot_.angle_rad = std::remainder(angle_rad, 2 * std::numbers::pi);
}

void ShotControl::set_power(double power) {
    if (std::isfinite(power)) shot_.power = std::clamp(power, kPowerStep, 1.0);
}

void ShotControl::set_tip(base::Vec2 left_up) {
    const double offset = glm::length(left_up);
    if (!std::isfinite(offset)) return;
    // A hair inside: the engine refuses what rounding puts outside.
    const double most = kMaxTipOffset * (1 - 1e-9);
    if (offset > most) left_up *= most / offset;
    shot_.tip_left = left_up.x;
    shot_.tip_up = left_up.y;
}

void ShotControl::set_elevation(double elevation_rad) {
    if (std::isfinite(elevation_rad)) {
        shot_.elevation_rad = std::clamp(elevation_rad, 0.0, kMaxElevation_rad);
    }
}

void ShotControl::pull_to(double back_m) {
    if (is_pulled() && std::isfinite(back_m)) pulled_m_ = std::clamp(back_m, 0.0, 1.0);
}

std::optional<model::Shot> ShotControl::release() {
    const double pulled_m = pulled_m_.value_or(0.0);
    cancel_pull();
    if (pulled_m < kLeastPull_m) return std::nullopt;
    set_power(pulled_m);
    return shot_;
}

void ShotControl::start_turn() {
    cancel_pull();
    set_tip({});
    set_elevation(0.0);
    call_ = model::NoCall{};
}

}  // namespace billiards::client
