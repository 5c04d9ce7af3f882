// Takes two balls that touch and the normal impulse between them; gives what friction between them
// does.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"
#include "common/physics/parameters.h"

namespace billiards::physics {

/// A ball during a collision.
struct Body {
    model::BallSpec spec;
    model::BallState state;
    bool is_on_slate = true;  ///< Then the slate takes every vertical impulse.

    double inverse_mass_pkg() const { return 1.0 / spec.mass_kg; }
};

/// How a collision changes a ball.
struct Kick {
    base::Vec3 velocity_mps{};
    base::Vec3 spin_radps{};
};

struct PairKick {
    Kick a;
    Kick b;
};

/// mu(s) for the slip speed s of the contact points.
double ball_friction(const Parameters& parameters, double slip_mps);

double ball_ball_restitution(const Parameters& parameters);

/// The tangential impulse along the slip of the contact points, min(mu(s) J, m s / 7) for equal
/// balls, on a and b. `normal` points from a to b, J = normal_impulse_ns. Where each ball shares
/// its slip between `sharing` contacts at once, the bound that stops it is shared likewise.
PairKick friction_kick(const Parameters& parameters, const Body& a, const Body& b,
                       const base::Vec3& normal, double normal_impulse_ns, int sharing);

/// What the slate leaves of a change of velocity.
inline base::Vec3 as_free(const Body& body, const base::Vec3& change) {
    return body.is_on_slate ? base::Vec3{change.x, change.y, 0.0} : change;
}

}  // namespace billiards::physics
