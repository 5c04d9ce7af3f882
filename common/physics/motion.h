// Takes a ball's state; gives how it moves from then on: one polynomial segment, and when that
// segment ends because the ball's motion changes.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"
#include "common/physics/parameters.h"
#include "common/timeline/timeline.h"

#include <algorithm>
#include <limits>

namespace billiards::physics {

/// The time of what does not happen.
inline constexpr double kNever_s = std::numeric_limits<double>::infinity();

/// Slower than this is rounding: a slip is rolling, a speed is rest.
inline constexpr double kStill_mps = 1e-12;

/// A ball's motion until it changes by itself. The ball is always evaluated from the segment's
/// start, never stepped, so that no error adds up.
struct Plan {
    timeline::Segment segment;
    double end_s = kNever_s;  ///< When the motion changes; kNever_s where it does not.
};

/// z x v: a quarter turn about the vertical.
inline base::Vec3 quarter_turn(const base::Vec3& v) {
    return {-v.y, v.x, 0.0};
}

/// Velocity of the point of a ball that touches the slate: u = v + R (z x w), horizontal.
inline base::Vec3 slip_mps(const model::BallState& ball, double radius_m) {
    return {ball.velocity_mps.x - radius_m * ball.spin_radps.y,
            ball.velocity_mps.y + radius_m * ball.spin_radps.x, 0.0};
}

/// A sphere's moment of inertia over m R^2.
inline constexpr double kInertiaRatio = 0.4;

/// The same state with its motion named. Slip and speed that are only rounding are taken away, the
/// slip by the 2/7 of it that friction would take, so that no energy is added. A ball on the slate
/// has z = radius and no vertical velocity; any other is airborne.
model::BallState settled(const Parameters& parameters, double radius_m, model::BallState state);

/// The motion that follows from a settled state.
Plan plan_motion(const Parameters& parameters, double radius_m, const model::BallState& settled,
                 double start_s);

/// The settled state in which a plan ends, at plan.end_s. A plan that ends in the air gives the
/// ball at the height of the slate, still falling.
model::BallState state_at_end(const Parameters& parameters, double radius_m, const Plan& plan);

/// Kinetic energy, and potential energy above the slate.
double energy_j(const Parameters& parameters, const model::BallSpec& spec,
                const model::BallState& state);

inline base::Vec3 position_at(const timeline::Segment& segment, double time_s) {
    const double elapsed = time_s - segment.start_s;
    return segment.position_m +
           (segment.velocity_mps + segment.acceleration_mps2 * (elapsed / 2)) * elapsed;
}

inline base::Vec3 velocity_at(const timeline::Segment& segment, double time_s) {
    return segment.velocity_mps + segment.acceleration_mps2 * (time_s - segment.start_s);
}

/// As timeline::evaluate, for times within the plan.
inline model::BallState state_at(const timeline::Segment& segment, double time_s) {
    const double elapsed = time_s - segment.start_s;
    base::Vec3 spin = segment.spin_radps + segment.spin_rate_radps2 * elapsed;
    const bool has_stopped = segment.spin_radps.z * spin.z <= 0.0;
    if (has_stopped) spin.z = 0.0;
    return {.position_m = position_at(segment, time_s),
            .velocity_mps = velocity_at(segment, time_s),
            .spin_radps = spin,
            .motion = segment.motion};
}

/// Whether the ball changes place.
inline bool is_travelling(model::Motion motion) {
    return motion == model::Motion::Rolling || motion == model::Motion::Sliding ||
           motion == model::Motion::Airborne;
}

}  // namespace billiards::physics
