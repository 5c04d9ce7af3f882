// Takes a mesh's vertices and faces; gives each vertex the average of its faces' normals.
#pragma once

#include "client/scene/mesh.h"

namespace billiards::client {

/// Algorithm 3.1 of the original gl-billiards: at each coordinate, the sum of the cross products
/// (P1 - P2) x (P1 - P3) of the faces that meet there over their number; then made one long.
/// Vertices of one mesh at the same place share their normal, so that a texture's seam is no edge
/// to the eye; what should look sharp is two meshes. Where no face gives a direction, it is up.
void average_normals(Mesh& mesh);

}  // namespace billiards::client
