// Takes a mesh; gives it averaged normals, in doubles, so that no finite coordinate overflows.
#include "client/scene/normals.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>

namespace billiards::client {

namespace {

struct NormalSum {
    glm::dvec3 normal{};
    int faces = 0;
};

/// For each vertex, the vertex that stands for its place.
std::vector<std::uint32_t> places_of(const std::vector<Vertex>& vertices) {
    const auto place = [&](std::uint32_t i) {
        const glm::vec3& p = vertices[i].position_m;
        return std::tuple(p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple(place(a), a) < std::tuple(place(b), b);
    });
    std::vector<std::uint32_t> places(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_known = i > 0 && place(order[i]) == place(order[i - 1]);
        places[order[i]] = is_known ? places[order[i - 1]] : order[i];
    }
    return places;
}

}  // namespace

void average_normals(Mesh& mesh) {
    const std::vector<std::uint32_t> places = places_of(mesh.vertices);
    std::vector<NormalSum> sums(mesh.vertices.size());
    for (std::size_t face = 0; face + 2 < mesh.indices.size(); face += 3) {
        const auto corner = [&](std::size_t i) {
            return glm::dvec3(mesh.vertices[mesh.indices[face + i]].position_m);
        };
        const glm::dvec3 normal = glm::cross(corner(0) - corner(1), corner(0) - corner(2));
        for (std::size_t i = 0; i < 3; ++i) {
            NormalSum& sum = sums[places[mesh.indices[face + i]]];
            sum.normal += normal;
            ++sum.faces;
        }
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const NormalSum& sum = sums[places[i]];
        const double length = glm::length(sum.normal) / std::max(1, sum.faces);
        const glm::dvec3 average = sum.normal / static_cast<double>(std::max(1, sum.faces));
        mesh.vertices[i].normal = length > 0 ? glm::vec3(average / length) : glm::vec3(0, 0, 1);
    }
}

}  // namespace billiards::client
