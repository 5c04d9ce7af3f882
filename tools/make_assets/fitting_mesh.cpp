// Takes a table's plan; gives its pockets with their leather rims, the sights and the foot spot.
#include "common/base/elementary.h"
#include "tools/make_assets/fittings.h"
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

constexpr double kInch_m = 0.0254;

/// A line of a rim's profile: how far outside the hole's edge, and how far above the wood's top.
struct RimLine {
    double outside_m = 0.0;
    double above_m = 0.0;
};
/// From inside to outside, over the roll of leather.
constexpr std::array<RimLine, 8> kRim{{{0.0030, -0.0030},
                                       {0.0028, 0.0000},
                                       {0.0036, 0.0026},
                                       {0.0062, 0.0044},
                                       {0.0098, 0.0048},
                                       {0.0132, 0.0036},
                                       {0.0152, 0.0014},
                                       {0.0156, -0.0004}}};
/// Below the wood's top: radius outside the hole's edge, and height.
constexpr std::array<RimLine, 4> kWall{
    {{-0.012, -0.090}, {-0.004, -0.050}, {0.003, -0.014}, {0.003, -0.001}}};

Point rim_point(const PocketPlan& pocket, double angle, double outside_m, double height_m,
                Fitting fitting) {
    const Vec2 place = pocket.hole.center_m + (pocket.hole.radius_m + outside_m) *
                                                  Vec2(base::cosine(angle), base::sine(angle));
    return {Vec3(place, height_m), texture_place(fitting)};
}

/// How much of the roll's width the wood has room for: the side pockets lie close to the edge.
double rim_share(const PocketPlan& pocket) {
    const double inside = kRim.front().outside_m;
    const double room = pocket.wood_m - kRounding_m - inside;
    return std::min(1.0, room / (kRim.back().outside_m - inside));
}

/// The roll of leather on the wood: it flattens out towards the rubber.
void add_rim(Mesh& mesh, const PocketPlan& pocket, double top_m) {
    const std::vector<double>& arc = pocket.wood_arc_rad;
    const double share = rim_share(pocket);
    const auto swell = [&](std::size_t i) {
        const double end = static_cast<double>(std::min(i, arc.size() - 1 - i));
        return std::min(1.0, (end + 1.0) / 4.0) * (0.5 + 0.5 * share);
    };
    std::vector<Row> rows;
    // From above, right is outside when the arc's angle grows upwards.
    for (std::size_t i = 0; i < arc.size(); ++i) {
        Row row;
        for (const RimLine& line : kRim) {
            const double above = line.above_m > 0 ? line.above_m * swell(i) : line.above_m;
            const double outside =
                kRim.front().outside_m + share * (line.outside_m - kRim.front().outside_m);
            row.push_back(rim_point(pocket, arc[i], outside, top_m + above, Fitting::Leather));
        }
        rows.push_back(std::move(row));
    }
    add_sheet(mesh, rows);
}

/// The leather that stands between wood and hole, from the bed up to the rim.
void add_lining(Mesh& mesh, const PocketPlan& pocket, double top_m) {
    Row low;
    Row high;
    for (auto angle = pocket.wood_arc_rad.rbegin(); angle != pocket.wood_arc_rad.rend(); ++angle) {
        low.push_back(rim_point(pocket, *angle, kWall.back().outside_m, kWall.back().above_m,
                                Fitting::Lining));
        high.push_back(rim_point(pocket, *angle, kRim.front().outside_m,
                                 top_m + kRim.front().above_m, Fitting::Leather));
    }
    add_sheet(mesh, {low, high});
}

/// The hole below the bed, and its bottom.
void add_hole(Mesh& mesh, const PocketPlan& pocket) {
    constexpr int kSides = 40;
    std::vector<Row> rows(kWall.size() + 1);
    for (int side = kSides; side >= 0; --side) {
        const double angle = 2 * base::kPi * (side % kSides) / kSides;
        rows[0].push_back(
            {Vec3(pocket.hole.center_m, kWall[0].above_m), texture_place(Fitting::Depth)});
        for (std::size_t i = 0; i < kWall.size(); ++i) {
            rows[i + 1].push_back(rim_point(pocket, angle, kWall[i].outside_m, kWall[i].above_m,
                                            i < 2 ? Fitting::Depth : Fitting::Lining));
        }
    }
    add_sheet(mesh, rows);
}

void add_shape(Mesh& mesh, const std::vector<Vec2>& outline, double height_m, Fitting fitting) {
    Row row;
    for (const Vec2& place : outline)
        row.push_back({Vec3(place, height_m), texture_place(fitting)});
    add_plate(mesh, row);
}

/// WPA Equipment Specifications, 5: diamonds of 7/16 by 1 inch.
void add_sight(Mesh& mesh, const TablePlan& plan, std::size_t i) {
    constexpr double kAboveWood_m = 0.0003;
    const RailPlan& rail = plan.rails[i / 3];
    const Vec2 across = kInch_m / 2 * rail.into;
    const Vec2 along = 0.4375 * kInch_m / 2 * rail.along;
    const Vec2 at = plan.sights[i];
    add_shape(mesh, {at - along, at + across, at + along, at - across},
              plan.top_height_m + kAboveWood_m, Fitting::Pearl);
}

Mesh spot_of(const model::TableSpec& table) {
    constexpr int kSides = 24;
    constexpr double kRadius_m = 0.006;
    constexpr double kAboveCloth_m = 0.0003;
    std::vector<Vec2> outline;
    for (int side = 0; side < kSides; ++side) {
        const double angle = 2 * base::kPi * side / kSides;
        outline.push_back(model::foot_spot(table) +
                          kRadius_m * Vec2(base::cosine(angle), base::sine(angle)));
    }
    Mesh mesh{.name = "spot", .vertices = {}, .indices = {}};
    add_shape(mesh, outline, kAboveCloth_m, Fitting::Spot);
    return mesh;
}

}  // namespace

std::vector<Mesh> fitting_meshes(const model::TableSpec& table) {
    const TablePlan plan = plan_of(table);
    Mesh rims{.name = "rims", .vertices = {}, .indices = {}};
    Mesh linings{.name = "linings", .vertices = {}, .indices = {}};
    Mesh holes{.name = "holes", .vertices = {}, .indices = {}};
    for (const PocketPlan& pocket : plan.pockets) {
        add_rim(rims, pocket, plan.top_height_m);
        add_lining(linings, pocket, plan.top_height_m);
        add_hole(holes, pocket);
    }
    Mesh sights{.name = "sights", .vertices = {}, .indices = {}};
    for (std::size_t i = 0; i < plan.sights.size(); ++i) add_sight(sights, plan, i);
    return {rims, linings, holes, sights, spot_of(table)};
}

}  // namespace billiards::make_assets
