// Gives the room in which the table stands: what the camera must not pass and the models fill.
#pragma once

namespace billiards::client {

/// Of the floor; the bed is at 0. WPA Equipment Specifications, 3: a bed 29 1/4 to 31 inches high.
inline constexpr double kFloor_m = -0.765;
/// Half the side of the square of floor that is drawn; it is dark from there on.
inline constexpr double kHalfRoom_m = 5.0;
/// From tip to butt; WPA Equipment Specifications, 18: at least 40 inches.
inline constexpr double kCueLength_m = 1.47;

}  // namespace billiards::client
