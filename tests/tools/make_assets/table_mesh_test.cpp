// Holds the drawn tables against the physics' ones: what looks like a jaw is the jaw.
#include "tools/make_assets/table_mesh.h"

#include "client/scene/normals.h"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

namespace billiards::make_assets {
namespace {

using base::Vec2;
using client::Mesh;
using model::TableSize;
using model::TableSpec;

constexpr double kFloat = 1e-6;  ///< What a float of a metre or two leaves.

const Mesh& named(const std::vector<Mesh>& meshes, const std::string& name) {
    const auto mesh = std::find_if(meshes.begin(), meshes.end(),
                                   [&](const Mesh& each) { return each.name == name; });
    CHECK(mesh != meshes.end());
    return *mesh;
}

Vec2 seen_from_above(const client::Vertex& vertex) {
    return {vertex.position_m.x, vertex.position_m.y};
}

bool has_vertex(const Mesh& mesh, const Vec2& place, double height_m) {
    return std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const auto& vertex) {
        return glm::distance(seen_from_above(vertex), place) < kFloat &&
               std::fabs(vertex.position_m.z - height_m) < kFloat;
    });
}

class DrawnTable : public ::testing::TestWithParam<TableSize> {
  protected:
    const TableSpec& table() const { return model::table_of(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(All, DrawnTable,
                         ::testing::Values(TableSize::SevenFoot, TableSize::EightFoot,
                                           TableSize::NineFoot));

TEST_P(DrawnTable, HasANoseAtBothEndsOfEveryCushionSegment) {
    const auto meshes = cushion_meshes(table());
    for (const model::CushionSegment& segment : table().cushions) {
        EXPECT_TRUE(has_vertex(named(meshes, "cushions"), segment.from_m, table().nose_height_m));
        EXPECT_TRUE(has_vertex(named(meshes, "cushions"), segment.to_m, table().nose_height_m));
    }
}

TEST_P(DrawnTable, RoundsItsJawsOnTheirArcs) {
    const auto meshes = cushion_meshes(table());
    for (const model::JawArc& jaw : table().jaws) {
        int on_arc = 0;
        for (const client::Vertex& vertex : named(meshes, "cushions").vertices) {
            const double distance = glm::distance(seen_from_above(vertex), jaw.center_m);
            const bool is_at_nose = std::fabs(vertex.position_m.z - table().nose_height_m) < kFloat;
            if (!is_at_nose || distance > 2 * jaw.radius_m) continue;
            EXPECT_NEAR(distance, jaw.radius_m, kFloat);
            ++on_arc;
        }
        EXPECT_GE(on_arc, 7);
    }
}

TEST_P(DrawnTable, NoRubberStandsInTheWayOfABallAtNoseHeight) {
    const auto meshes = cushion_meshes(table());
    const Vec2 half = table().half_playing_m;
    for (const client::Vertex& vertex : named(meshes, "cushions").vertices) {
        const Vec2 place = glm::abs(seen_from_above(vertex));
        EXPECT_FALSE(place.x < half.x - kFloat && place.y < half.y - kFloat);
    }
}

TEST_P(DrawnTable, EndsItsBedOnThePocketCircles) {
    const auto meshes = cloth_meshes(table());
    std::vector<int> on_edge(table().pockets.size());
    for (const client::Vertex& vertex : named(meshes, "bed").vertices) {
        EXPECT_EQ(vertex.position_m.z, 0.0F);
        for (std::size_t i = 0; i < on_edge.size(); ++i) {
            const model::PocketCircle& pocket = table().pockets[i];
            const double distance = glm::distance(seen_from_above(vertex), pocket.center_m);
            EXPECT_GT(distance, pocket.radius_m - kFloat);
            on_edge[i] += distance < pocket.radius_m + kFloat ? 1 : 0;
        }
    }
    for (const int points : on_edge) EXPECT_GE(points, 20);
}

TEST_P(DrawnTable, CoversTheWholeBedButThePockets) {
    const auto meshes = cloth_meshes(table());
    const Mesh& bed = named(meshes, "bed");
    const auto is_covered = [&](const Vec2& place) {
        for (std::size_t i = 0; i < bed.indices.size(); i += 3) {
            bool is_inside = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec2 a = seen_from_above(bed.vertices[bed.indices[i + k]]);
                const Vec2 b = seen_from_above(bed.vertices[bed.indices[i + (k + 1) % 3]]);
                is_inside &= (b.x - a.x) * (place.y - a.y) >= (b.y - a.y) * (place.x - a.x) - 1e-9;
            }
            if (is_inside) return true;
        }
        return false;
    };
    const Vec2 half = table().half_playing_m;
    for (int i = -20; i <= 20; ++i) {
        for (int k = -20; k <= 20; ++k) {
            const Vec2 place = half * Vec2(i, k) / 20.0;
            const bool is_hole = std::any_of(
                table().pockets.begin(), table().pockets.end(), [&](const auto& pocket) {
                    return glm::distance(place, pocket.center_m) < pocket.radius_m;
                });
            EXPECT_NE(is_covered(place), is_hole) << place.x << ' ' << place.y;
        }
    }
}

TEST_P(DrawnTable, ReachesExactlyToTheOuterEdge) {
    const auto meshes = wood_meshes(table());
    Vec2 farthest{0.0};
    for (const client::Vertex& vertex : named(meshes, "rails").vertices) {
        farthest = glm::max(farthest, glm::abs(seen_from_above(vertex)));
    }
    EXPECT_NEAR(farthest.x, table().half_outer_m.x, kFloat);
    EXPECT_NEAR(farthest.y, table().half_outer_m.y, kFloat);
}

TEST_P(DrawnTable, LeavesThePocketsOpenInTheWood) {
    const auto meshes = wood_meshes(table());
    for (const client::Vertex& vertex : named(meshes, "rails").vertices) {
        for (const model::PocketCircle& pocket : table().pockets) {
            EXPECT_GT(glm::distance(seen_from_above(vertex), pocket.center_m), pocket.radius_m);
        }
    }
}

TEST_P(DrawnTable, KeepsItsFittingsOnTheWood) {
    for (const Mesh& mesh : fitting_meshes(table())) {
        for (const client::Vertex& vertex : mesh.vertices) {
            const Vec2 place = glm::abs(seen_from_above(vertex));
            EXPECT_TRUE(glm::all(glm::lessThan(place, table().half_outer_m))) << mesh.name;
        }
    }
}

TEST_P(DrawnTable, HasEighteenSights) {
    const auto meshes = fitting_meshes(table());
    EXPECT_EQ(named(meshes, "sights").indices.size(), 18U * 2U * 3U);
}

TEST_P(DrawnTable, FacesUpWhereItIsSeenFromAbove) {
    Mesh bed = cloth_meshes(table()).front();
    Mesh shade = shade_meshes(table()).front();
    for (Mesh* mesh : {&bed, &shade}) {
        client::average_normals(*mesh);
        for (const client::Vertex& vertex : mesh->vertices) {
            EXPECT_FLOAT_EQ(vertex.normal.z, 1.0F) << mesh->name;
        }
    }
}

TEST_P(DrawnTable, ShadesTheBedJustAboveIt) {
    const Mesh shade = shade_meshes(table()).front();
    for (const client::Vertex& vertex : shade.vertices) {
        EXPECT_GT(vertex.position_m.z, 0.0F);
        EXPECT_LT(vertex.position_m.z, 0.0003F);
    }
}

TEST_P(DrawnTable, StaysWhatItIsWhenTurnedByHalfATurn) {
    const auto meshes = cushion_meshes(table());
    const Mesh& cushions = named(meshes, "cushions");
    for (const client::Vertex& vertex : cushions.vertices) {
        EXPECT_TRUE(has_vertex(cushions, -seen_from_above(vertex), vertex.position_m.z));
    }
}

TEST_P(DrawnTable, StaysWhatItIsInAMirror) {
    const auto meshes = cushion_meshes(table());
    const Mesh& cushions = named(meshes, "cushions");
    for (const client::Vertex& vertex : cushions.vertices) {
        const Vec2 mirrored = Vec2(-1, 1) * seen_from_above(vertex);
        EXPECT_TRUE(has_vertex(cushions, mirrored, vertex.position_m.z))
            << mirrored.x << ' ' << mirrored.y;
    }
}

}  // namespace
}  // namespace billiards::make_assets
