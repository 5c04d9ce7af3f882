// Takes a number and a place on the plane; gives how far the place is from the number's ink.
#pragma once

#include "common/base/vec.h"

#include <vector>

namespace billiards::make_assets {

/// A number from 0 to 99 as strokes: lines through points, drawn with a round pen. Centred on the
/// origin, the digits one unit high. 6 and 9 alone are underlined, so that neither is the other.
struct Lettering {
    std::vector<std::vector<base::Vec2>> strokes;
    double pen = 0.0;  ///< Half the strokes' width.
};

Lettering lettering(int number);

/// From a place to the ink's edge; negative within the ink.
double distance_to_ink(const Lettering& lettering, const base::Vec2& place);

}  // namespace billiards::make_assets
