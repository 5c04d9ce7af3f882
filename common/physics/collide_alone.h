// Takes two balls, or a ball and a cushion, that meet and touch nothing else; gives them after it.
#pragma once

#include "common/physics/collide_ball.h"
#include "common/physics/collide_cushion.h"

namespace billiards::physics {

/// The model alone, at any speed: a shot lets what closes slower than kFloor_mps part without
/// friction. Balls on the slate have no vertical velocity after it. What does not close is left as
/// it is. `normal` is the unit vector from a to b.
void collide_alone(const Parameters& parameters, Body& a, Body& b, const base::Vec3& normal);

/// The closing speed of `contact` follows from the ball.
void collide_alone(const Parameters& parameters, Body& ball, NoseContact contact);

}  // namespace billiards::physics
