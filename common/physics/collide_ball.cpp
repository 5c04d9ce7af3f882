// Takes two balls that touch; gives friction between them.
#include "common/physics/collide_ball.h"

#include "common/base/elementary.h"
#include "common/physics/motion.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

using base::Vec3;

double ball_friction(const Parameters& parameters, double slip_mps) {
    return parameters.ball_friction_base +
           parameters.ball_friction_scale *
               base::exponential(-parameters.ball_friction_decay_spm * slip_mps);
}

double ball_ball_restitution(const Parameters& parameters) {
    return parameters.ball_ball == BallBallModel::Elastic ? 1.0 : parameters.ball_ball_restitution;
}

/// Slip of a's contact point over b's: the tangential part of v_a - v_b, + (R_a w_a + R_b w_b) x n.
/// An impulse p along it changes it by p (7/2) (1/m_a + 1/m_b): a sphere's contact point gives way
/// 7/2 times as easily as its centre. Alciatore TP A-14.
PairKick friction_kick(const Parameters& parameters, const Body& a, const Body& b,
                       const Vec3& normal, double normal_impulse_ns, int sharing) {
    const Vec3 relative = a.state.velocity_mps - b.state.velocity_mps;
    const Vec3 rim = a.spec.radius_m * a.state.spin_radps + b.spec.radius_m * b.state.spin_radps;
    const Vec3 slip = relative - glm::dot(relative, normal) * normal + glm::cross(rim, normal);
    const double slip_speed = std::sqrt(glm::dot(slip, slip));
    if (slip_speed <= kStill_mps) return {};

    const double to_stop =
        slip_speed / (3.5 * sharing * (a.inverse_mass_pkg() + b.inverse_mass_pkg()));
    const double by_friction = ball_friction(parameters, slip_speed) * normal_impulse_ns;
    const Vec3 impulse = (std::min(to_stop, by_friction) / slip_speed) * slip;

    // The torque is R n x (-impulse) on a and (-R n) x impulse on b: the same.
    const Vec3 torque_per_radius = glm::cross(impulse, normal) / kInertiaRatio;
    return {.a = {as_free(a, -impulse) * a.inverse_mass_pkg(),
                  torque_per_radius * (a.inverse_mass_pkg() / a.spec.radius_m)},
            .b = {as_free(b, impulse) * b.inverse_mass_pkg(),
                  torque_per_radius * (b.inverse_mass_pkg() / b.spec.radius_m)}};
}

}  // namespace billiards::physics
