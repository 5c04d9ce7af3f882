// Takes a number; gives the shot of that number, the same everywhere.
#pragma once

#include "common/model/table_spec.h"
#include "common/physics/parameters.h"
#include "common/physics/simulate.h"

#include <cstdint>
#include <vector>

namespace billiards::physics {

struct NumberedCase {
    const model::TableSpec& table;
    Parameters parameters;
    std::vector<BallStart> balls;
};

/// Of each eight, five are hard breaks of a frozen rack, and one each has scattered, unequal and
/// flying balls, many of them frozen to each other; of those three, some have another model of
/// balls or cushions, or the classic preset.
NumberedCase numbered_case(std::uint64_t number);

}  // namespace billiards::physics
