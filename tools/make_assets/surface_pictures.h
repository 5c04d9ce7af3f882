// Gives the pictures of cloth, wood and floor; each joins itself at its edges.
#pragma once

#include "tools/make_assets/picture.h"

namespace billiards::make_assets {

/// Worsted cloth in tournament green.
Picture cloth_picture();

/// Polished mahogany; the grain runs along u.
Picture wood_picture();

/// Dark oak planks along u, eight abreast.
Picture floor_picture();

}  // namespace billiards::make_assets
