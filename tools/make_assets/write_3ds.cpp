// Takes meshes; gives the chunks of the 3D Studio file format, innermost first.
#include "tools/make_assets/write_3ds.h"

#include "common/base/check.h"

#include <utility>

namespace billiards::make_assets {

namespace {

constexpr std::uint32_t kVersion = 3;
constexpr const char* kMaterial = "surface";

Bytes chunk(std::uint16_t id, const Bytes& body) {
    ByteWriter writer;
    writer.u16(id);
    writer.u32(static_cast<std::uint32_t>(6 + body.size()));
    writer.append(body);
    return std::move(writer).take();
}

/// A chunk whose body is what fill(ByteWriter&) writes.
template <class Fill>
Bytes chunk_of(std::uint16_t id, Fill fill) {
    ByteWriter body;
    fill(body);
    return chunk(id, std::move(body).take());
}

std::uint16_t count(std::size_t size) {
    CHECK(size <= 0xffffU);
    return static_cast<std::uint16_t>(size);
}

Bytes material(std::string_view texture) {
    return chunk_of(0xAFFF, [&](ByteWriter& body) {
        body.append(chunk_of(0xA000, [](ByteWriter& name) { name.text(kMaterial); }));
        body.append(chunk_of(0xA200, [&](ByteWriter& map) {
            map.append(chunk_of(0x0030, [](ByteWriter& percent) { percent.u16(100); }));
            map.append(chunk_of(0xA300, [&](ByteWriter& file) { file.text(texture); }));
        }));
    });
}

Bytes vertices(const client::Mesh& mesh) {
    return chunk_of(0x4110, [&](ByteWriter& body) {
        body.u16(count(mesh.vertices.size()));
        for (const client::Vertex& vertex : mesh.vertices) {
            body.f32(vertex.position_m.x);
            body.f32(vertex.position_m.y);
            body.f32(vertex.position_m.z);
        }
    });
}

Bytes texture_places(const client::Mesh& mesh) {
    return chunk_of(0x4140, [&](ByteWriter& body) {
        body.u16(count(mesh.vertices.size()));
        for (const client::Vertex& vertex : mesh.vertices) {
            body.f32(vertex.uv.x);
            body.f32(vertex.uv.y);
        }
    });
}

/// The faces, and that all of them have the one material.
Bytes faces(const client::Mesh& mesh) {
    constexpr std::uint16_t kAllEdgesVisible = 7;
    const std::size_t number = mesh.indices.size() / 3;
    return chunk_of(0x4120, [&](ByteWriter& body) {
        body.u16(count(number));
        for (std::size_t face = 0; face < number; ++face) {
            for (std::size_t i = 0; i < 3; ++i) body.u16(count(mesh.indices[3 * face + i]));
            body.u16(kAllEdgesVisible);
        }
        body.append(chunk_of(0x4130, [&](ByteWriter& group) {
            group.text(kMaterial);
            group.u16(count(number));
            for (std::size_t face = 0; face < number; ++face) group.u16(count(face));
        }));
    });
}

Bytes object(const client::Mesh& mesh) {
    return chunk_of(0x4000, [&](ByteWriter& body) {
        body.text(mesh.name);
        body.append(chunk_of(0x4100, [&](ByteWriter& parts) {
            parts.append(vertices(mesh));
            parts.append(faces(mesh));
            parts.append(texture_places(mesh));
        }));
    });
}

}  // namespace

Bytes write_3ds(std::span<const client::Mesh> meshes, std::string_view texture) {
    return chunk_of(0x4D4D, [&](ByteWriter& file) {
        file.append(chunk_of(0x0002, [](ByteWriter& version) { version.u32(kVersion); }));
        file.append(chunk_of(0x3D3D, [&](ByteWriter& edit) {
            edit.append(chunk_of(0x3D3E, [](ByteWriter& version) { version.u32(kVersion); }));
            edit.append(material(texture));
            for (const client::Mesh& mesh : meshes) edit.append(object(mesh));
        }));
    });
}

}  // namespace billiards::make_assets
