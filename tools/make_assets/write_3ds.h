// Takes meshes and the name of their texture; gives them as a .3ds file.
#pragma once

#include "client/scene/mesh.h"
#include "tools/make_assets/byte_writer.h"

#include <span>
#include <string_view>

namespace billiards::make_assets {

/// Positions, texture places and faces are kept; normals are not part of the format. Each mesh may
/// have 65,535 vertices and faces at most.
Bytes write_3ds(std::span<const client::Mesh> meshes, std::string_view texture);

}  // namespace billiards::make_assets
