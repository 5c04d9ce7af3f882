// Gives a ball that meets one cushion, and what a model of the cushion makes of it.
#pragma once

#include "common/physics/collide_alone.h"
#include "common/physics/motion.h"
#include "tests/common/physics/still_life.h"

namespace billiards::physics {

inline Parameters with_cushion(CushionModel model, double restitution, double friction) {
    Parameters parameters;
    parameters.cushion = model;
    parameters.cushion_restitution = restitution;
    parameters.cushion_friction = friction;
    return parameters;
}

/// On the slate.
inline Body lone_ball(const Vec3& velocity_mps, const Vec3& spin_radps,
                      const model::BallSpec& spec = {}) {
    return {.spec = spec,
            .state = {.position_m = {0, 0, spec.radius_m},
                      .velocity_mps = velocity_mps,
                      .spin_radps = spin_radps}};
}

/// After a cushion towards +x, whose nose stands this far above the ball's centre.
inline Body bounced(const Parameters& parameters, Body ball, double lean_sine = 0.27) {
    collide_alone(parameters, ball, {.into = {1, 0}, .lean_sine = lean_sine});
    return ball;
}

inline double energy_of(const Body& ball) {
    return energy_j({}, ball.spec, ball.state);
}

/// Any ball that drives into the cushion.
inline Body random_ball(base::Random& random) {
    return lone_ball(
        {random.uniform(0.01, 8), random.uniform(-8, 8), 0},
        {random.uniform(-200, 200), random.uniform(-200, 200), random.uniform(-200, 200)});
}

/// How far apart two outcomes are, in the larger of speed and rim speed.
inline double distance_of(const Body& a, const Body& b) {
    return std::max(speed_of(a.state.velocity_mps - b.state.velocity_mps),
                    a.spec.radius_m * speed_of(a.state.spin_radps - b.state.spin_radps));
}

}  // namespace billiards::physics
