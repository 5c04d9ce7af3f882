// Gives what a player decides: the strike of the cue, and what was said beforehand.
#pragma once

#include "common/model/ball.h"

#include <cstdint>
#include <variant>

namespace billiards::model {

/// The strike. Whether its numbers make sense is asked of physics::validate.
struct Shot {
    double angle_rad = 0.0;      ///< Where the cue points, counterclockwise from +x.
    double power = 0.5;          ///< In (0, 1]: metres that the cue is pulled back.
    double tip_left = 0.0;       ///< Tip offset in ball radii, left of centre seen along the cue.
    double tip_up = 0.0;         ///< Tip offset in ball radii, above centre.
    double elevation_rad = 0.0;  ///< How far the butt is raised, in [0, pi/2).

    friend bool operator==(const Shot&, const Shot&) = default;
};

/// A pocket's number: 0 - 5 anticlockwise from (-x, -y), so 1 and 4 are the side pockets.
struct PocketId {
    std::uint8_t number = 0;

    friend auto operator<=>(PocketId, PocketId) = default;
};

inline constexpr int kPockets = 6;

struct NoCall {
    friend bool operator==(NoCall, NoCall) = default;
};
struct CalledBall {
    BallId ball;
    PocketId pocket;

    friend bool operator==(const CalledBall&, const CalledBall&) = default;
};
struct Safety {
    friend bool operator==(Safety, Safety) = default;
};

/// At nine- and ten-ball, on the shot after the break: no ball need be hit.
struct PushOut {
    friend bool operator==(PushOut, PushOut) = default;
};

/// What the shooter says before the shot. The order is part of the wire format; only append.
using Call = std::variant<NoCall, CalledBall, Safety, PushOut>;

}  // namespace billiards::model
