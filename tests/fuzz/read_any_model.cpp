// Takes any bytes; gives them to the reader, and looks at every vertex it makes of them.
#include "tests/fuzz/read_any_model.h"

#include "client/scene/model_3ds.h"
#include "common/base/check.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace billiards::fuzz {

namespace {

void check_drawable(const client::Mesh& mesh) {
    for (const client::Vertex& vertex : mesh.vertices) {
        for (glm::length_t i = 0; i < 3; ++i) CHECK(std::isfinite(vertex.position_m[i]));
        for (glm::length_t i = 0; i < 2; ++i) CHECK(std::isfinite(vertex.uv[i]));
        CHECK(std::fabs(glm::length(vertex.normal) - 1.0F) < 1e-4F);
    }
    CHECK(mesh.indices.size() % 3 == 0);
    for (const std::uint32_t index : mesh.indices) CHECK(index < mesh.vertices.size());
}

}  // namespace

void read_any_model(std::span<const std::byte> bytes) {
    const auto meshes = client::read_3ds(bytes);
    if (!meshes) {
        CHECK(!client::in_words(meshes.error().fault).empty());
        CHECK(meshes.error().at_byte <= bytes.size());
        return;
    }
    CHECK(!meshes->empty() && meshes->size() <= client::kMaxMeshes);
    for (const client::Mesh& mesh : *meshes) check_drawable(mesh);
}

}  // namespace billiards::fuzz
