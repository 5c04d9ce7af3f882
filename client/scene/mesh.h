// Gives triangles as the renderer takes them: vertices with normal and texture place, and indices.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace billiards::client {

/// Floats, and in this order, so that a vertex buffer is one copy of the vector.
struct Vertex {
    glm::vec3 position_m{};
    glm::vec3 normal{};  ///< Of length 1.
    glm::vec2 uv{};      ///< (0, 0) is the picture's lower left corner, (1, 1) its upper right one.

    friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// Three indices a triangle, anticlockwise seen from outside; each is below vertices.size().
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;

    friend bool operator==(const Mesh&, const Mesh&) = default;
};

}  // namespace billiards::client
