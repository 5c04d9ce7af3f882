// Takes a table as the physics has it; gives what is drawn of it: cloth, wood and fittings.
#pragma once

#include "client/scene/mesh.h"
#include "common/model/table_spec.h"

#include <vector>

namespace billiards::make_assets {

/// The bed is at z = 0 and the origin in its middle, as in the physics. A nose stands exactly at
/// the cushion's segment and jaw arcs, at nose height; the bed ends exactly at the pocket circles.
/// Each mesh is smooth; where two meet is an edge.

/// The bed, down into the pockets, for the cloth's texture: one picture a 0.3 m square.
std::vector<client::Mesh> cloth_meshes(const model::TableSpec& table);

/// The cushions, for the darker cloth over them, at the same scale.
std::vector<client::Mesh> cushion_meshes(const model::TableSpec& table);

/// What the noses take of the room's light from the bed: a strip just above it along every
/// cushion, for a picture that darkens what lies under it; v is 0.5 at the foot and 1 outside.
std::vector<client::Mesh> shade_meshes(const model::TableSpec& table);

/// Rails, cabinet and legs, for the wood's texture: u runs along the grain, 1.2 m a picture, v
/// across it, 0.4 m.
std::vector<client::Mesh> wood_meshes(const model::TableSpec& table);

/// Pockets, sights and spots, for the fittings' texture: places in cells of one colour.
std::vector<client::Mesh> fitting_meshes(const model::TableSpec& table);

}  // namespace billiards::make_assets
