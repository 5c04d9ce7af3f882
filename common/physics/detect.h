// Takes two motions, or a motion and something fixed; gives the time from now at which they meet.
#pragma once

#include "common/base/vec.h"
#include "common/physics/roots.h"

namespace billiards::physics {

/// Within this gap two bodies touch.
inline constexpr double kTouching_m = 1e-12;
/// Bodies that touch and approach no faster than this are not closing.
inline constexpr double kClosing_mps = 1e-12;
/// How deep bodies that touch and are pressed together sink before their next contact is due: deep
/// enough that they then close at a speed that is more than rounding, far less than the 1e-9 m of
/// overlap that nothing may exceed.
inline constexpr double kRestingDepth_m = 2.5e-10;

/// A point that moves with constant acceleration: position + velocity t + acceleration t^2 / 2.
struct Course {
    base::Vec3 position_m{};
    base::Vec3 velocity_mps{};
    base::Vec3 acceleration_mps2{};
};

/// A straight wall of unlimited length: `normal` is a unit vector towards the side that counts.
struct Line {
    base::Vec2 point_m{};
    base::Vec2 normal{};
};

/// When the distance of the point `difference` (one centre seen from another) from the origin comes
/// down to distance_m, in [0, horizon_s]; kNever_s where it does not. The rules of contact:
/// apart: the first time at which the gap closes; touching and closing: now; touching and parting:
/// when they have opened and close again; touching and neither: when the gap is kRestingDepth_m
/// below zero.
double meeting_s(const Course& difference, double distance_m, double horizon_s);

/// The same for a point that comes down to distance_m above a line, seen from the line's side. A
/// point behind the line has to come out first.
double meeting_s(const Course& course, const Line& line, double distance_m, double horizon_s);

/// When a point enters a circle of this radius about the origin from outside; heights do not count.
double entering_s(const Course& difference, double radius_m, double horizon_s);

/// The first time after now at which value + rate t + acceleration t^2 / 2 comes down to 0.
double falling_s(double value, double rate, double acceleration, double horizon_s);

}  // namespace billiards::physics
