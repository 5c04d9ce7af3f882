// Takes a ball that drives into a cushion's nose; gives what the cushion does to it.
#pragma once

#include "common/base/vec.h"
#include "common/physics/collide_ball.h"
#include "common/physics/parameters.h"

namespace billiards::physics {

struct NoseContact {
    base::Vec2 into{};         ///< Unit vector from the ball towards the cushion.
    double lean_sine = 0.0;    ///< Height of the nose above the ball's centre, in radii.
    double closing_mps = 0.0;  ///< Along the normal: `into`, leant for an airborne ball.
};

/// A ball on the slate cannot follow a leaning normal: its normal is horizontal. An airborne ball's
/// points at the nose.
base::Vec3 nose_normal(const NoseContact& contact, bool is_on_slate);

/// What the model of these parameters does. The slip comes from the ball, the speed that the
/// cushion stops and throws back from `contact`: with one contact that is the ball's own; where the
/// ball touches more at once it is this contact's share. Alone it never adds energy.
Kick cushion_kick(const Parameters& parameters, const Body& ball, const NoseContact& contact);

}  // namespace billiards::physics
