// Gives the balls and shots that physics tests start from.
#pragma once

#include "common/base/elementary.h"
#include "common/base/random.h"
#include "common/model/rack.h"
#include "common/model/table_spec.h"
#include "common/physics/simulate.h"
#include "common/timeline/evaluate.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace billiards::physics {

using base::Vec2;
using base::Vec3;
using model::BallId;
using model::EventKind;
using model::Motion;

inline constexpr double kRadius_m = model::BallSpec{}.radius_m;
inline constexpr double kMass_kg = model::BallSpec{}.mass_kg;

inline void PrintTo(const Error& error, std::ostream* out) {
    *out << "error " << static_cast<int>(error.code) << " '" << error.detail << "'";
}

/// A ball on the slate.
inline BallStart ball_at(int number, Vec2 position_m, Vec2 velocity_mps = {},
                         Vec3 spin_radps = {}) {
    return {.ball = BallId{static_cast<std::uint8_t>(number)},
            .position_m = {position_m, kRadius_m},
            .velocity_mps = {velocity_mps, 0.0},
            .spin_radps = spin_radps};
}

/// The spin of a ball that rolls with this velocity.
inline Vec3 rolling_spin(Vec2 velocity_mps) {
    return Vec3{-velocity_mps.y, velocity_mps.x, 0.0} / kRadius_m;
}

inline const model::TableSpec& nine_foot() {
    return model::table_of(model::TableSize::NineFoot);
}

inline timeline::ShotRecord solved(const model::TableSpec& table, const Parameters& parameters,
                                   const std::vector<BallStart>& balls,
                                   Diagnostics* diagnostics = nullptr) {
    auto record = simulate(table, parameters, balls, diagnostics);
    EXPECT_TRUE(record.ok()) << (record.ok() ? "" : record.error().detail);
    return record.ok() ? *std::move(record) : timeline::ShotRecord{};
}

inline const timeline::BallTrack& track_of(const timeline::ShotRecord& record, int number) {
    for (const timeline::BallTrack& track : record.timeline.tracks) {
        if (track.ball.number == number) return track;
    }
    throw std::out_of_range("no such ball");
}

inline model::BallState state_of(const timeline::ShotRecord& record, int number, double time_s) {
    return timeline::evaluate(track_of(record, number), time_s);
}

inline std::vector<model::ShotEvent> events_of(const timeline::ShotRecord& record, EventKind kind) {
    std::vector<model::ShotEvent> events;
    std::copy_if(record.events.begin(), record.events.end(), std::back_inserter(events),
                 [&](const model::ShotEvent& event) { return event.kind == kind; });
    return events;
}

inline double speed_of(const Vec3& v) {
    return std::sqrt(glm::dot(v, v));
}

/// A frozen rack on the foot spot, and the cue ball struck from the head spot.
inline std::vector<BallStart> break_shot(const model::TableSpec& table, Vec2 velocity_mps,
                                         Vec3 spin_radps = {}) {
    std::vector<BallStart> balls{ball_at(0, model::head_spot(table), velocity_mps, spin_radps)};
    for (const Vec2& place : model::triangle_positions(table, kRadius_m)) {
        balls.push_back(ball_at(static_cast<int>(balls.size()), place));
    }
    return balls;
}

/// Scattered balls, many of them frozen to each other, in rows or to a cushion; some move.
class Scatter {
  public:
    Scatter(base::Random& random, const model::TableSpec& table) : random_(random), table_(table) {}

    std::vector<BallStart> balls(std::size_t count, bool many_move) {
        std::vector<BallStart> balls;
        for (int attempt = 0; attempt < 2000 && balls.size() < count; ++attempt) {
            BallStart ball = ball_at(static_cast<int>(balls.size()), place(balls));
            if (!is_free(base::horizontal(ball.position_m), balls)) continue;
            if (balls.empty() || (many_move && random_.below(2) == 0)) set_off(ball);
            balls.push_back(ball);
        }
        return balls;
    }

  private:
    Vec2 place(const std::vector<BallStart>& others) {
        const Vec2 reach = table_.half_playing_m - kRadius_m;
        const Vec2 anywhere{random_.uniform(-reach.x, reach.x), random_.uniform(-reach.y, reach.y)};
        const auto kind = random_.below(4);
        if (kind == 0) return {anywhere.x, random_.below(2) == 0 ? reach.y : -reach.y};
        if (kind > 2 || others.empty()) return anywhere;
        const BallStart& other = others[random_.below(others.size())];
        const double angle = kind == 1 ? base::kPi / 3 * static_cast<double>(random_.below(6))
                                       : random_.uniform(0.0, 2 * base::kPi);
        return base::horizontal(other.position_m) +
               2 * kRadius_m * Vec2{base::cosine(angle), base::sine(angle)};
    }

    bool is_free(const Vec2& place, const std::vector<BallStart>& others) const {
        const Vec2 reach = table_.half_playing_m - kRadius_m;
        if (std::abs(place.x) > reach.x || std::abs(place.y) > reach.y) return false;
        for (const model::JawArc& jaw : table_.jaws) {
            if (glm::distance(place, jaw.center_m) < jaw.radius_m + kRadius_m) return false;
        }
        for (const model::PocketCircle& pocket : table_.pockets) {
            if (glm::distance(place, pocket.center_m) < pocket.radius_m + kRadius_m) return false;
        }
        return std::all_of(others.begin(), others.end(), [&](const BallStart& other) {
            return glm::distance(place, base::horizontal(other.position_m)) > 2 * kRadius_m - 1e-13;
        });
    }

    void set_off(BallStart& ball) {
        const double share = random_.uniform(0.0, 1.0);
        const double angle = random_.uniform(0.0, 2 * base::kPi);
        const double speed = 12.0 * share * share;
        ball.velocity_mps = {speed * base::cosine(angle), speed * base::sine(angle), 0.0};
        if (random_.below(2) == 0) return;
        for (int axis = 0; axis < 3; ++axis) ball.spin_radps[axis] = random_.uniform(-200.0, 200.0);
    }

    base::Random& random_;
    const model::TableSpec& table_;
};

}  // namespace billiards::physics
