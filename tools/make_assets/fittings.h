// Gives the colours of a table's small parts, and where in their common picture each lies.
#pragma once

#include "common/base/vec.h"
#include "tools/make_assets/picture.h"

#include <cstdint>

namespace billiards::make_assets {

/// A cell each in the picture, from left to right.
enum class Fitting : std::uint8_t { Leather, Lining, Depth, Pearl, Spot, Brass };

/// The middle of a fitting's cell.
base::Vec2 texture_place(Fitting fitting);

Picture fittings_picture();

}  // namespace billiards::make_assets
