// Takes a strike of the cue; gives the ball's motion as the tip leaves it.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"
#include "common/model/shot.h"
#include "common/physics/parameters.h"

namespace billiards::physics {

struct Strike {
    base::Vec3 velocity_mps{};  ///< Before the slate acts on a downward part.
    base::Vec3 spin_radps{};
};

/// Speed of the cue that sends the ball away with k t p / m when it hits level and central
/// (original design, equation 3).
double cue_speed_mps(const Parameters& parameters, const model::BallSpec& ball, double power);

/// Off-centre hits lose speed, gain spin and, with `squirt`, turn away from the offset: Alciatore
/// TP. The shot must be valid.
Strike strike(const Parameters& parameters, const model::BallSpec& ball, const model::Shot& shot,
              double cue_speed_mps, bool squirt = true);

}  // namespace billiards::physics
