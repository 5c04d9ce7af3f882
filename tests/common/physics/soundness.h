// Takes a solved shot; gives the first thing about it that cannot be.
#pragma once

#include "common/model/table_spec.h"
#include "common/physics/parameters.h"
#include "common/physics/simulate.h"
#include "common/timeline/shot_record.h"

#include <optional>
#include <span>
#include <string>

namespace billiards::physics {

/// A shot on a table with marks, none of whose bodies overlapped at the start.
struct SolvedShot {
    const model::TableSpec& table;
    const Parameters& parameters;
    std::span<const BallStart> balls;
    const timeline::ShotRecord& record;
    const Diagnostics& diagnostics;
};

/// Energy that rose, momentum that balls lost to each other, bodies that overlap at an event or
/// between two, places or velocities that jump, balls that do not come to rest or rest where none
/// can: in words. Nothing where all is well.
std::optional<std::string> first_fault(const SolvedShot& shot);

}  // namespace billiards::physics
