// Takes a ball that comes down on the slate; gives how it goes on.
#pragma once

#include "common/model/ball.h"
#include "common/physics/parameters.h"

namespace billiards::physics {

/// The vertical speed is reversed times the ball-table restitution (a rebound under 0.05 m/s is
/// none); friction with the cloth acts along the slip, until it stops it at most. Motion is not
/// named yet: `settled` does that. `falling` moves downwards.
model::BallState landed(const Parameters& parameters, double radius_m, model::BallState falling);

}  // namespace billiards::physics
