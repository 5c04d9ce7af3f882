// Takes a ball that comes down on the slate; gives its bounce.
#include "common/physics/collide_slate.h"

#include "common/physics/motion.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

/// A rebound slower than this is none: it would rise by an eighth of a millimetre.
constexpr double kLeastRebound_mps = 0.05;

}  // namespace

/// Coulomb: the tangential impulse is min(mu J, (2/7) m |u|) against the slip u, J = the normal
/// one.
model::BallState landed(const Parameters& parameters, double radius_m, model::BallState falling) {
    const double fall = -falling.velocity_mps.z;
    const double rebound = parameters.ball_table_restitution * fall;
    falling.velocity_mps.z = rebound < kLeastRebound_mps ? 0.0 : rebound;
    const double normal = fall + falling.velocity_mps.z;

    const base::Vec3 slip = slip_mps(falling, radius_m);
    const double slip_speed = std::sqrt(glm::dot(slip, slip));
    if (slip_speed <= kStill_mps || parameters.rolls_at_once) return falling;
    const double grip = std::min(2.0 / 7.0 * slip_speed, parameters.sliding_friction * normal);
    const base::Vec3 change = (grip / slip_speed) * slip;
    falling.velocity_mps -= change;
    falling.spin_radps += quarter_turn(change) / (kInertiaRatio * radius_m);
    return falling;
}

}  // namespace billiards::physics
