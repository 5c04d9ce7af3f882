// Takes how fine it shall be; gives a ball of radius 1 for the pictures of ball_picture.h.
#pragma once

#include "client/scene/mesh.h"

namespace billiards::make_assets {

/// 2 * sides * (bands - 1) triangles. u is the longitude and v the latitude.
client::Mesh ball_mesh(int sides, int bands);

}  // namespace billiards::make_assets
