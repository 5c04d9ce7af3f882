// Holds averaged normals against solids whose normals are known.
#include "client/scene/normals.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>

namespace billiards::client {
namespace {

Mesh mesh_of(std::vector<glm::vec3> places, std::vector<std::uint32_t> indices) {
    Mesh mesh{.name = "solid", .vertices = {}, .indices = std::move(indices)};
    for (const glm::vec3& place : places) mesh.vertices.push_back({.position_m = place});
    return mesh;
}

void expect_near(const glm::vec3& actual, const glm::vec3& expected) {
    EXPECT_LT(glm::distance(actual, expected), 1e-6F)
        << actual.x << ' ' << actual.y << ' ' << actual.z;
}

TEST(AverageNormals, OfATriangleSeenAnticlockwisePointToTheViewer) {
    Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
    average_normals(mesh);
    for (const Vertex& vertex : mesh.vertices) expect_near(vertex.normal, {0, 0, 1});
}

TEST(AverageNormals, AtAnEdgeLieBetweenTheFaces) {
    Mesh roof = mesh_of({{0, 0, 1}, {1, 0, 1}, {0, -1, 0}, {0, 1, 0}}, {0, 2, 1, 0, 1, 3});
    average_normals(roof);
    expect_near(roof.vertices[0].normal, {0, 0, 1});
    expect_near(roof.vertices[2].normal, glm::normalize(glm::vec3(0, -1, 1)));
    expect_near(roof.vertices[3].normal, glm::normalize(glm::vec3(0, 1, 1)));
}

TEST(AverageNormals, AreSharedAcrossATexturesSeam) {
    Mesh roof = mesh_of({{0, 0, 1}, {1, 0, 1}, {0, -1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 0}},
                        {0, 2, 1, 3, 4, 5});
    average_normals(roof);
    for (const std::size_t i : {0U, 1U, 3U, 4U}) expect_near(roof.vertices[i].normal, {0, 0, 1});
}

TEST(AverageNormals, AreUpWhereNoFaceGivesADirection) {
    Mesh mesh = mesh_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}}, {0, 1, 2});
    average_normals(mesh);
    for (const Vertex& vertex : mesh.vertices) expect_near(vertex.normal, {0, 0, 1});
}

TEST(AverageNormals, AreOneLongForTheLargestAndSmallestTriangles) {
    for (const float size :
         {std::numeric_limits<float>::max(), std::numeric_limits<float>::denorm_min()}) {
        Mesh mesh = mesh_of({{-size, 0, -size}, {size, 0, -size}, {0, 0, size}}, {0, 1, 2});
        average_normals(mesh);
        for (const Vertex& vertex : mesh.vertices) expect_near(vertex.normal, {0, -1, 0});
    }
}

}  // namespace
}  // namespace billiards::client
