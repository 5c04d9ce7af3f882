// Holds sheets, plates and turned bodies against their areas and the way they face.
#include "tools/make_assets/surface.h"

#include "common/base/elementary.h"
#include "tools/make_assets/ball_mesh.h"

#include <array>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace billiards::make_assets {
namespace {

/// The sum of the faces' area vectors, and of their areas.
struct Area {
    glm::dvec3 vector{};
    double total = 0.0;
};

Area area_of(const client::Mesh& mesh) {
    Area area;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position_m);
        };
        const glm::dvec3 face = glm::cross(corner(1) - corner(0), corner(2) - corner(0)) / 2.0;
        area.vector += face;
        area.total += glm::length(face);
    }
    return area;
}

TEST(Plate, CoversAnOutlineWithBaysAndFacesUp) {
    // A square of 3 with a bay of 1 by 2 in its upper edge.
    Row outline;
    for (const base::Vec2 place :
         {base::Vec2(0, 0), base::Vec2(3, 0), base::Vec2(3, 3), base::Vec2(2, 3), base::Vec2(2, 1),
          base::Vec2(1, 1), base::Vec2(1, 3), base::Vec2(0, 3)}) {
        outline.push_back({base::Vec3(place, 0.0), {}});
    }
    client::Mesh mesh;
    add_plate(mesh, outline);
    EXPECT_NEAR(area_of(mesh).vector.z, 7.0, 1e-9);
    EXPECT_NEAR(area_of(mesh).total, 7.0, 1e-9);
}

TEST(Sheet, FacesWhoSeesItsRowsGoUpAndItsPointsGoRight) {
    client::Mesh mesh;
    add_sheet(mesh, {{{{0, 0, 0}, {}}, {{2, 0, 0}, {}}}, {{{0, 0, 1}, {}}, {{2, 0, 1}, {}}}});
    EXPECT_LT(glm::distance(area_of(mesh).vector, glm::dvec3(0, -2, 0)), 1e-9);
}

TEST(Sheet, LeavesOutTrianglesWithoutArea) {
    client::Mesh mesh;
    add_sheet(mesh, {{{{0, 0, 0}, {}}, {{2, 0, 0}, {}}}, {{{0, 0, 1}, {}}, {{0, 0, 1}, {}}}});
    EXPECT_EQ(mesh.indices.size(), 3U);
}

TEST(Turned, ABallIsClosedAndNearlyRound) {
    const client::Mesh ball = ball_mesh(32, 30);
    EXPECT_EQ(ball.indices.size() / 3, 2U * 32U * 29U);
    EXPECT_LT(glm::length(area_of(ball).vector), 1e-6);
    EXPECT_NEAR(area_of(ball).total, 4 * base::kPi, 0.012 * 4 * base::kPi);
    for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
        const glm::vec3 a = ball.vertices[ball.indices[i]].position_m;
        const glm::vec3 b = ball.vertices[ball.indices[i + 1]].position_m;
        const glm::vec3 c = ball.vertices[ball.indices[i + 2]].position_m;
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a + b + c), 0.0F);
    }
}

}  // namespace
}  // namespace billiards::make_assets
