// Takes a table and a seed; gives balls to start from: single ones, frozen racks, and scatterings
// of which many balls touch.
#pragma once

#include "common/base/elementary.h"
#include "common/base/random.h"
#include "common/model/rack.h"
#include "common/model/table_spec.h"
#include "common/physics/simulate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace billiards::physics {

using base::Vec2;
using base::Vec3;
using model::BallId;

inline constexpr double kRadius_m = model::BallSpec{}.radius_m;
inline constexpr double kMass_kg = model::BallSpec{}.mass_kg;

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

inline double speed_of(const Vec3& v) {
    return std::sqrt(glm::dot(v, v));
}

inline Vec2 unit_vector(double angle_rad) {
    return {base::cosine(angle_rad), base::sine(angle_rad)};
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

struct ScatterKind {
    std::size_t balls = 12;
    bool many_move = false;
    bool are_unequal = false;  ///< In mass and radius.
    bool many_fly = false;
};

/// Scattered balls, many of them frozen to each other, in rows or to a cushion; some move.
class Scatter {
  public:
    Scatter(base::Random& random, const model::TableSpec& table) : random_(random), table_(table) {}

    std::vector<BallStart> balls(std::size_t count, bool many_move) {
        return balls({.balls = count, .many_move = many_move});
    }

    std::vector<BallStart> balls(const ScatterKind& kind) {
        std::vector<BallStart> balls;
        for (int attempt = 0; attempt < 2000 && balls.size() < kind.balls; ++attempt) {
            BallStart ball = ball_at(static_cast<int>(balls.size()), {});
            if (kind.are_unequal) {
                ball.spec.radius_m *= random_.uniform(0.8, 1.2);
                ball.spec.mass_kg *= random_.uniform(0.5, 2.0);
            }
            ball.position_m = {place(ball.spec.radius_m, balls), ball.spec.radius_m};
            if (kind.many_fly && random_.below(3) == 0) throw_up(ball);
            if (!is_free(ball, balls)) continue;
            if (balls.empty() || (kind.many_move && random_.below(2) == 0)) set_off(ball);
            balls.push_back(ball);
        }
        return balls;
    }

  private:
    Vec2 place(double radius_m, const std::vector<BallStart>& others) {
        const Vec2 reach = table_.half_playing_m - radius_m;
        const Vec2 anywhere{random_.uniform(-reach.x, reach.x), random_.uniform(-reach.y, reach.y)};
        const auto kind = random_.below(4);
        if (kind == 0) return {anywhere.x, random_.below(2) == 0 ? reach.y : -reach.y};
        if (kind > 2 || others.empty()) return anywhere;
        const BallStart& other = others[random_.below(others.size())];
        const double angle = kind == 1 ? base::kPi / 3 * static_cast<double>(random_.below(6))
                                       : random_.uniform(0.0, 2 * base::kPi);
        const double sum = radius_m + other.spec.radius_m;
        const double rise = other.spec.radius_m - radius_m;  // Their centres differ in height.
        return base::horizontal(other.position_m) +
               std::sqrt(sum * sum - rise * rise) * unit_vector(angle);
    }

    bool is_free(const BallStart& ball, const std::vector<BallStart>& others) const {
        const double radius = ball.spec.radius_m;
        const Vec2 place = base::horizontal(ball.position_m);
        const Vec2 reach = table_.half_playing_m - radius;
        if (std::abs(place.x) > reach.x || std::abs(place.y) > reach.y) return false;
        for (const model::JawArc& jaw : table_.jaws) {
            if (glm::distance(place, jaw.center_m) < jaw.radius_m + radius) return false;
        }
        for (const model::PocketCircle& pocket : table_.pockets) {
            if (glm::distance(place, pocket.center_m) < pocket.radius_m + radius) return false;
        }
        return std::all_of(others.begin(), others.end(), [&](const BallStart& other) {
            return glm::distance(ball.position_m, other.position_m) >
                   radius + other.spec.radius_m - 1e-13;
        });
    }

    void set_off(BallStart& ball) {
        const double share = random_.uniform(0.0, 1.0);
        const double angle = random_.uniform(0.0, 2 * base::kPi);
        const double speed = 12.0 * share * share;
        ball.velocity_mps += Vec3{speed * unit_vector(angle), 0.0};
        if (random_.below(2) == 0) return;
        for (int axis = 0; axis < 3; ++axis) ball.spin_radps[axis] = random_.uniform(-200.0, 200.0);
    }

    /// From the slate, or from somewhere above it and away from the noses, which a raised ball
    /// meets earlier.
    void throw_up(BallStart& ball) {
        ball.velocity_mps.z = random_.uniform(-2.0, 2.0);
        const Vec2 room = table_.half_playing_m - glm::abs(base::horizontal(ball.position_m));
        const bool is_near_nose = std::min(room.x, room.y) < 2 * ball.spec.radius_m;
        if (!is_near_nose && random_.below(2) == 0) ball.position_m.z += random_.uniform(0.0, 0.1);
    }

    base::Random& random_;
    const model::TableSpec& table_;
};

}  // namespace billiards::physics
