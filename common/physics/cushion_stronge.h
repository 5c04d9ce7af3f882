// Takes a ball that drives into a cushion's nose; gives what a nose does that yields like a spring,
// along the normal and across it.
#pragma once

#include "common/physics/collide_cushion.h"

namespace billiards::physics {

/// Stronge, "Impact Mechanics" (2000), 5.1: compliant contact with friction. Contact and ball swing
/// across the normal 1.8 times as fast as along it; the way out takes e times as long as the way
/// in; the contact slips while the spring across pulls harder than friction holds. The ball is
/// free; the slate takes the vertical part of what this leaves.
Kick stronge_kick(const Parameters& parameters, const Body& ball, const NoseContact& contact);

}  // namespace billiards::physics
