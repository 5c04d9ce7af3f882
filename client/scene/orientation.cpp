// Takes spins; gives orientations by the rotation that the spin in the middle of a step makes.
#include "client/scene/orientation.h"

#include "common/base/random.h"
#include "common/timeline/evaluate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace billiards::client {

namespace {

constexpr double kStep_s = 1.0 / 240;
/// A shot is over long before; times beyond are taken as this.
constexpr double kLongest_s = 600.0;

/// From one time of a ball's track to another, by the spin half way.
glm::dquat rolled(const glm::dquat& from, const timeline::BallTrack& track, double from_s,
                  double to_s) {
    const model::BallState half_way = timeline::evaluate(track, (from_s + to_s) / 2);
    return turned(from, half_way.spin_radps, to_s - from_s);
}

}  // namespace

glm::dquat turned(const glm::dquat& from, const base::Vec3& spin_radps, double duration_s) {
    const double speed = glm::length(spin_radps);
    if (speed == 0.0) return from;
    return glm::normalize(glm::angleAxis(speed * duration_s, spin_radps / speed) * from);
}

Orientations::Orientations() {
    base::Random random(15);
    for (glm::dquat& turned_ball : shown_) {
        const auto part = [&] { return random.uniform(-1.0, 1.0); };
        const double w = part();
        const double x = part();
        const double y = part();
        turned_ball = glm::normalize(glm::dquat(w, x, y, part()));
    }
    start_shot();
}

void Orientations::start_shot() {
    before_shot_ = shown_;
    on_grid_ = shown_;
    steps_ = 0;
}

void Orientations::advance(const timeline::Timeline& timeline, double time_s) {
    const double time = std::clamp(time_s, 0.0, kLongest_s);
    const auto steps = static_cast<std::int64_t>(std::floor(time / kStep_s));
    if (steps < steps_) {
        on_grid_ = before_shot_;
        steps_ = 0;
    }
    for (const timeline::BallTrack& track : timeline.tracks) {
        glm::dquat& on_grid = on_grid_.at(track.ball.number);
        for (std::int64_t step = steps_; step < steps; ++step) {
            const double from_s = static_cast<double>(step) * kStep_s;
            on_grid = rolled(on_grid, track, from_s, from_s + kStep_s);
        }
        const double grid_s = static_cast<double>(steps) * kStep_s;
        shown_.at(track.ball.number) = rolled(on_grid, track, grid_s, time);
    }
    steps_ = steps;
}

}  // namespace billiards::client
