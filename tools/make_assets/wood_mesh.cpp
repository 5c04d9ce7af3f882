// Takes a table's plan; gives its boards with rounded edges, the cabinet below and four legs.
#include "client/scene/room.h"
#include "common/base/elementary.h"
#include "tools/make_assets/surface.h"
#include "tools/make_assets/table_mesh.h"
#include "tools/make_assets/table_plan.h"

#include <algorithm>
#include <array>

namespace billiards::make_assets {

namespace {

using base::Vec2;
using base::Vec3;
using client::Mesh;

constexpr Vec2 kTile_m{1.2, 0.4};
constexpr double kBoardBelow_m = -0.062;  ///< Where the boards end.
constexpr double kCabinetBelow_m = -0.30;
constexpr int kRoundingSteps = 5;

/// A line around the table: how far within the boards' outer edge and how high.
struct BandLine {
    double inset_m = 0.0;
    double height_m = 0.0;
};

Vec2 inset(const EdgePoint& point, double inset_m) {
    return point.place_m - inset_m * point.normal;
}

/// A band round the whole table, line by line from below; u along the rails, v over the lines.
void add_band(Mesh& mesh, const TablePlan& plan, const std::vector<BandLine>& lines) {
    for (const RailPlan& rail : plan.rails) {
        std::vector<Row> rows;
        double across_m = 0.0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (i > 0) {
                across_m += glm::length(Vec2(lines[i].inset_m - lines[i - 1].inset_m,
                                             lines[i].height_m - lines[i - 1].height_m));
            }
            Row row;
            for (const EdgePoint& point : rail.outer) {
                const Vec2 place = inset(point, lines[i].inset_m);
                row.push_back({Vec3(place, lines[i].height_m),
                               Vec2(glm::dot(rail.along, place), across_m) / kTile_m});
            }
            rows.push_back(std::move(row));
        }
        add_sheet(mesh, rows);
    }
}

std::vector<BandLine> board_lines(double top_m) {
    std::vector<BandLine> lines{
        {0.010, kBoardBelow_m - 0.003}, {0.003, kBoardBelow_m - 0.002}, {0.0, kBoardBelow_m}};
    for (int step = 0; step <= kRoundingSteps; ++step) {
        const double angle = base::kPi / 2 * step / kRoundingSteps;
        lines.push_back({kRounding_m * (1 - base::cosine(angle)),
                         top_m - kRounding_m * (1 - base::sine(angle))});
    }
    return lines;
}

void add_board_top(Mesh& mesh, const TablePlan& plan, const RailPlan& rail, double other_board) {
    // The last line of the rounding, to the bit: top and edge share their normals there.
    const BandLine rim = board_lines(plan.top_height_m).back();
    Row outline;
    const auto add = [&](const Vec2& place, double height_m) {
        const Vec2 on_board{glm::dot(rail.along, place), glm::dot(rail.into, place)};
        outline.push_back(
            {Vec3(place, height_m), on_board / kTile_m + Vec2(0.37, 0.29) * other_board});
    };
    for (const EdgePoint& point : rail.outer) add(inset(point, rim.inset_m), rim.height_m);
    for (auto place = rail.inner.rbegin(); place != rail.inner.rend(); ++place) {
        add(*place, rim.height_m);
    }
    add_plate(mesh, outline);
}

/// A turned leg, by its rings from the floor up: radius and height as shares of its own.
constexpr std::array<Vec2, 20> kLeg{{{0.00, 0.000}, {0.62, 0.000}, {0.70, 0.010}, {0.70, 0.050},
                                     {0.52, 0.075}, {0.56, 0.110}, {0.68, 0.125}, {0.68, 0.145},
                                     {0.56, 0.160}, {0.54, 0.260}, {0.62, 0.420}, {0.76, 0.560},
                                     {0.86, 0.640}, {0.88, 0.690}, {0.74, 0.725}, {0.72, 0.740},
                                     {0.96, 0.765}, {1.00, 0.790}, {1.00, 0.820}, {0.98, 1.000}}};
constexpr double kLegRadius_m = 0.085;

Mesh legs_of(const model::TableSpec& table) {
    constexpr int kSides = 24;
    constexpr Vec2 kFromEdge_m{0.26, 0.20};
    const double height = kCabinetBelow_m - client::kFloor_m;
    std::vector<Turn> rings;
    for (const Vec2& ring : kLeg) {
        rings.push_back({kLegRadius_m * ring.x, height * ring.y, height * ring.y / kTile_m.x});
    }
    Mesh mesh{.name = "legs", .vertices = {}, .indices = {}};
    for (const Vec2 side : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
        const Vec2 foot = side * (table.half_outer_m - kFromEdge_m);
        add_turned(mesh, Vec3(foot, client::kFloor_m), rings, kSides);
    }
    // The grain runs up the leg, and the grain is u.
    for (client::Vertex& vertex : mesh.vertices) std::swap(vertex.uv.x, vertex.uv.y);
    return mesh;
}

}  // namespace

std::vector<Mesh> wood_meshes(const model::TableSpec& table) {
    const TablePlan plan = plan_of(table);
    Mesh rails{.name = "rails", .vertices = {}, .indices = {}};
    add_band(rails, plan, board_lines(plan.top_height_m));
    for (std::size_t i = 0; i < plan.rails.size(); ++i) {
        add_board_top(rails, plan, plan.rails[i], static_cast<double>(i));
    }
    Mesh cabinet{.name = "cabinet", .vertices = {}, .indices = {}};
    // Below the boards it hides the side pockets, which reach nearly to the edge; then it narrows.
    add_band(cabinet, plan,
             {{0.300, kCabinetBelow_m},
              {0.076, kCabinetBelow_m},
              {0.070, kCabinetBelow_m + 0.004},
              {0.060, -0.170},
              {0.050, -0.135},
              {0.034, -0.112},
              {0.016, -0.100},
              {0.012, -0.096},
              {0.012, kBoardBelow_m - 0.003}});
    return {rails, cabinet, legs_of(table)};
}

}  // namespace billiards::make_assets
