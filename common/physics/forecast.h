// Takes balls with plans and a table; gives what each comes to next.
#pragma once

#include "common/physics/mover.h"
#include "common/physics/table_shape.h"

namespace billiards::physics {

/// Sets mover.alone and mover.swept from its plan, from now_s on.
void foresee_alone(const TableShape& shape, Mover& mover, double now_s);

/// When two balls meet, if neither comes to something alone before; kNever_s where they do not.
double meeting_time_s(const Mover& a, const Mover& b, double now_s);

/// The height of the nose above the ball's centre in radii; how much nearer than R a leaning nose
/// lets the centre of a ball on the slate come to it.
double lean_sine(const TableShape& shape, double radius_m, double height_m);
double nose_setback_m(const TableShape& shape, double radius_m);

}  // namespace billiards::physics
