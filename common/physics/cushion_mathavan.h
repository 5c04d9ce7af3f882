// Takes a ball on the slate that drives into a cushion's nose; gives what friction at the nose and
// at the slate make of it during the impact.
#pragma once

#include "common/physics/collide_cushion.h"

namespace billiards::physics {

/// Mathavan, Jackson, Parkin, "A theoretical analysis of billiard ball dynamics under cushion
/// impacts", Proc. IMechE C 224 (2010): the impact is integrated over the normal impulse of a rigid
/// nose, until the ball has stopped, then until the nose has given back e^2 of the work that
/// stopping it took. Cushion friction acts at the nose, sliding friction at the slate, which the
/// ball does not leave and which does not pull it. Exact to about 1e-10 of the ball's speed. Where
/// friction is so high that the ball would wedge between nose and slate, it comes back without
/// friction.
Kick mathavan_kick(const Parameters& parameters, const Body& ball, const NoseContact& contact);

}  // namespace billiards::physics
