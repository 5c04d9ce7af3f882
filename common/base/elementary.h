// Takes doubles; gives sine, cosine, arc tangent and exponential with the same bits on every
// machine and compiler, which libm's do not have. Built from + - * / and sqrt alone.
#pragma once

namespace billiards::base {

inline constexpr double kPi = 3.14159265358979323846;

inline constexpr double radians(double degrees) {
    return degrees * (kPi / 180.0);
}
inline constexpr double degrees(double radians) {
    return radians * (180.0 / kPi);
}

/// Error below 1e-15 for |angle_rad| <= 1000; NaN and infinity give NaN.
double sine(double angle_rad);
double cosine(double angle_rad);
/// The angle of (x, y) from +x, counterclockwise, in (-pi, pi]; (0, 0) gives 0. Error below 1e-15.
double arc_tangent(double y, double x);
/// asin for |x| <= 1, by arc_tangent.
double arc_sine(double x);
/// e^x, relative error below 1e-15; 0 below x = -745, infinity above 709.7.
double exponential(double x);

}  // namespace billiards::base
