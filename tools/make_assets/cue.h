// Gives the cue: its mesh and its picture.
#pragma once

#include "client/scene/mesh.h"
#include "tools/make_assets/picture.h"

namespace billiards::make_assets {

/// The tip's face touches the origin and the butt lies on -x, so that a cue that is not turned
/// points along +x, as a shot of angle 0 does. u runs from tip (0) to butt (1), v once round.
client::Mesh cue_mesh();

/// Blue tip, ivory ferrule, maple shaft, joint, four ebony points, linen wrap, butt.
Picture cue_picture();

}  // namespace billiards::make_assets
