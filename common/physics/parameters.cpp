// Gives the two presets.
#include "common/physics/parameters.h"

namespace billiards::physics {

Parameters realistic_parameters() {
    return {};
}

Parameters classic_parameters() {
    Parameters parameters;
    parameters.rolling_friction = 0.017;
    parameters.ball_ball = BallBallModel::Elastic;
    parameters.cushion = CushionModel::Mirror;
    parameters.cushion_restitution = 0.7;
    parameters.rolls_at_once = true;
    parameters.stop_speed_mps = 0.01;
    return parameters;
}

}  // namespace billiards::physics
