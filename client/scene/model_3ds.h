// Takes the bytes of a .3ds file, which nobody vouches for; gives its meshes, or what is wrong and
// where. Chunks it does not know are skipped.
#pragma once

#include "client/scene/mesh.h"
#include "common/base/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace billiards::client {

/// A file beyond one of these is refused. The format itself
/// counts the vertices and faces of one mesh in 16 bits.
inline constexpr std::size_t kMaxModelBytes = 16U << 20U;
inline constexpr std::size_t kMaxMeshes = 64;
inline constexpr std::size_t kMaxModelVertices = 262'144;
inline constexpr std::size_t kMaxModelFaces = 262'144;
inline constexpr std::size_t kMaxMeshName = 64;

enum class Model3dsFault : std::uint8_t {
    NotA3ds,
    FileTooLarge,
    ChunkBeyondItsParent,  ///< A length that lies, or a file cut short.
    ChunkTooShort,         ///< It promises more numbers than it holds.
    NameWithoutEnd,
    NumberNotFinite,
    IndexBeyondVertices,
    TexturePlacesDiffer,  ///< Not one texture place a vertex.
    TooManyMeshes,
    TooManyVertices,
    TooManyFaces,
    NoMesh,
};

struct Model3dsError {
    Model3dsFault fault{};
    std::size_t at_byte = 0;  ///< Of the chunk that is at fault.

    friend bool operator==(Model3dsError, Model3dsError) = default;
};

/// The part of a sentence that follows "the model": "ends in the middle of a chunk".
std::string_view in_words(Model3dsFault fault);

/// The meshes in the order of the file, with the normals of average_normals. A mesh without
/// texture places has (0, 0) everywhere; objects that are no mesh (lights, cameras) are skipped.
base::Result<std::vector<Mesh>, Model3dsError> read_3ds(std::span<const std::byte> bytes);

}  // namespace billiards::client
