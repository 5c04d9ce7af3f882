// Gives the pictures of cloth, wood and floor, each joining itself at its edges, and of shades.
#pragma once

#include "tools/make_assets/picture.h"

namespace billiards::make_assets {

/// Worsted cloth in tournament green.
Picture cloth_picture();
/// The same, a little darker: it is stretched over the cushions.
Picture cushion_picture();

// What is left of the light, for pictures that darken what lies under them; white at the rim.

/// Under a ball, which touches in the middle.
Picture ball_shade_picture();
/// Under a cushion's nose: its foot is at v = 0.5, and white at both ends.
Picture table_shade_picture();

/// Polished mahogany; the grain runs along u.
Picture wood_picture();

/// Dark oak planks along u, eight abreast.
Picture floor_picture();

}  // namespace billiards::make_assets
