// Takes bytes; gives meshes by walking the chunks 4D4D (file), 3D3D (edit), 4000 (object) and 4100
// (mesh): vertices 4110, faces 4120, texture places 4140.
#include "client/scene/model_3ds.h"

#include "client/scene/chunk_reader.h"
#include "client/scene/normals.h"

#include <cmath>
#include <optional>
#include <utility>

namespace billiards::client {

namespace {

constexpr std::uint16_t kFile = 0x4D4D;
constexpr std::uint16_t kEdit = 0x3D3D;
constexpr std::uint16_t kObject = 0x4000;
constexpr std::uint16_t kMesh = 0x4100;
constexpr std::uint16_t kVertices = 0x4110;
constexpr std::uint16_t kFaces = 0x4120;
constexpr std::uint16_t kTexturePlaces = 0x4140;

using Fault = std::optional<Model3dsError>;

/// Calls visit(Chunk) -> Fault for each chunk of `parent` until one is at fault.
template <class Visit>
Fault for_each_chunk(ByteReader parent, Visit visit) {
    while (!parent.empty()) {
        const std::size_t at = parent.at_byte();
        const std::optional<Chunk> chunk = next_chunk(parent);
        if (!chunk) return Model3dsError{Model3dsFault::ChunkBeyondItsParent, at};
        if (const Fault fault = visit(*chunk)) return fault;
    }
    return std::nullopt;
}

/// How many items of `item_bytes` a list chunk holds; none where it is shorter than it says.
std::optional<std::size_t> list_length(ByteReader& body, std::size_t item_bytes) {
    if (!body.has(2)) return std::nullopt;
    const std::size_t count = body.u16();
    if (!body.has(count * item_bytes)) return std::nullopt;
    return count;
}

/// A list of vectors of floats, into `list`.
template <class Vector>
Fault read_vectors(Chunk chunk, std::vector<Vector>& list) {
    const auto count = list_length(chunk.body, sizeof(Vector));
    if (!count) return Model3dsError{Model3dsFault::ChunkTooShort, chunk.at_byte};
    list.resize(*count);
    for (Vector& vector : list) {
        for (glm::length_t i = 0; i < Vector::length(); ++i) {
            vector[i] = chunk.body.f32();
            if (!std::isfinite(vector[i])) {
                return Model3dsError{Model3dsFault::NumberNotFinite, chunk.at_byte};
            }
        }
    }
    return std::nullopt;
}

Fault read_faces(Chunk chunk, std::vector<std::uint32_t>& indices) {
    constexpr std::size_t kFaceBytes = 8;  // Three indices and flags.
    const auto count = list_length(chunk.body, kFaceBytes);
    if (!count) return Model3dsError{Model3dsFault::ChunkTooShort, chunk.at_byte};
    indices.clear();
    indices.reserve(3 * *count);
    for (std::size_t face = 0; face < *count; ++face) {
        for (int corner = 0; corner < 3; ++corner) indices.push_back(chunk.body.u16());
        chunk.body.u16();
    }
    return std::nullopt;
}

struct MeshParts {
    std::vector<glm::vec3> positions_m;
    std::vector<glm::vec2> uvs;
    std::vector<std::uint32_t> indices;
};

Fault read_parts(const Chunk& mesh, MeshParts& parts) {
    return for_each_chunk(mesh.body, [&](const Chunk& chunk) -> Fault {
        if (chunk.id == kVertices) return read_vectors(chunk, parts.positions_m);
        if (chunk.id == kTexturePlaces) return read_vectors(chunk, parts.uvs);
        if (chunk.id == kFaces) return read_faces(chunk, parts.indices);
        return std::nullopt;
    });
}

/// What a mesh's chunks may not say of each other.
std::optional<Model3dsFault> contradiction_in(const MeshParts& parts) {
    if (!parts.uvs.empty() && parts.uvs.size() != parts.positions_m.size()) {
        return Model3dsFault::TexturePlacesDiffer;
    }
    for (const std::uint32_t index : parts.indices) {
        if (index >= parts.positions_m.size()) return Model3dsFault::IndexBeyondVertices;
    }
    return std::nullopt;
}

Mesh assembled(std::string name, MeshParts parts) {
    Mesh mesh{.name = std::move(name), .vertices = {}, .indices = std::move(parts.indices)};
    mesh.vertices.resize(parts.positions_m.size());
    parts.uvs.resize(parts.positions_m.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        mesh.vertices[i].position_m = parts.positions_m[i];
        mesh.vertices[i].uv = parts.uvs[i];
    }
    average_normals(mesh);
    return mesh;
}

/// The meshes so far, and how much of the limits they have used.
struct Collected {
    std::vector<Mesh> meshes;
    std::size_t vertices = 0;
    std::size_t faces = 0;
};

std::optional<Model3dsFault> limit_met(const Collected& so_far, const MeshParts& parts) {
    if (so_far.meshes.size() == kMaxMeshes) return Model3dsFault::TooManyMeshes;
    if (so_far.vertices + parts.positions_m.size() > kMaxModelVertices) {
        return Model3dsFault::TooManyVertices;
    }
    if (so_far.faces + parts.indices.size() / 3 > kMaxModelFaces) {
        return Model3dsFault::TooManyFaces;
    }
    return std::nullopt;
}

Fault read_mesh(const Chunk& chunk, const std::string& name, Collected& collected) {
    MeshParts parts;
    if (const Fault fault = read_parts(chunk, parts)) return fault;
    auto fault = contradiction_in(parts);
    if (!fault) fault = limit_met(collected, parts);
    if (fault) return Model3dsError{*fault, chunk.at_byte};
    collected.vertices += parts.positions_m.size();
    collected.faces += parts.indices.size() / 3;
    collected.meshes.push_back(assembled(name, std::move(parts)));
    return std::nullopt;
}

Fault read_object(Chunk object, Collected& collected) {
    const std::optional<std::string> name = object.body.text(kMaxMeshName);
    if (!name) return Model3dsError{Model3dsFault::NameWithoutEnd, object.at_byte};
    return for_each_chunk(object.body, [&](const Chunk& chunk) -> Fault {
        return chunk.id == kMesh ? read_mesh(chunk, *name, collected) : std::nullopt;
    });
}

}  // namespace

base::Result<std::vector<Mesh>, Model3dsError> read_3ds(std::span<const std::byte> bytes) {
    if (bytes.size() > kMaxModelBytes) return Model3dsError{Model3dsFault::FileTooLarge, 0};
    ByteReader reader(bytes, 0);
    if (!reader.has(2) || ByteReader(reader).u16() != kFile) {
        return Model3dsError{Model3dsFault::NotA3ds, 0};
    }
    const std::optional<Chunk> file = next_chunk(reader);
    if (!file) return Model3dsError{Model3dsFault::ChunkBeyondItsParent, 0};

    Collected collected;
    const Fault fault = for_each_chunk(file->body, [&](const Chunk& chunk) -> Fault {
        if (chunk.id != kEdit) return std::nullopt;
        return for_each_chunk(chunk.body, [&](const Chunk& part) -> Fault {
            return part.id == kObject ? read_object(part, collected) : std::nullopt;
        });
    });
    if (fault) return *fault;
    if (collected.meshes.empty()) return Model3dsError{Model3dsFault::NoMesh, 0};
    return std::move(collected.meshes);
}

std::string_view in_words(Model3dsFault fault) {
    switch (fault) {
        case Model3dsFault::NotA3ds:
            return "is no .3ds file";
        case Model3dsFault::FileTooLarge:
            return "is larger than 16 MiB";
        case Model3dsFault::ChunkBeyondItsParent:
            return "is cut short, or gives a length that goes beyond its part";
        case Model3dsFault::ChunkTooShort:
            return "holds a list that is shorter than it says";
        case Model3dsFault::NameWithoutEnd:
            return "holds a name without an end";
        case Model3dsFault::NumberNotFinite:
            return "holds a coordinate that is no number";
        case Model3dsFault::IndexBeyondVertices:
            return "holds a face beyond its vertices";
        case Model3dsFault::TexturePlacesDiffer:
            return "does not hold one texture place a vertex";
        case Model3dsFault::TooManyMeshes:
            return "holds too many meshes";
        case Model3dsFault::TooManyVertices:
            return "holds too many vertices";
        case Model3dsFault::TooManyFaces:
            return "holds too many faces";
        case Model3dsFault::NoMesh:
            return "holds no mesh";
    }
    CHECK(false);
}

}  // namespace billiards::client
