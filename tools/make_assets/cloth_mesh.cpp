// Takes a table's plan; gives its bed, its cushions by their profile, the cloth that goes over the
// edge of the slate, and the shade under the noses.
#include "common/base/elementary.h"
#include "tools/make_assets/surface.h"
#include "tools/make_assets/table_mesh.h"
#include "tools/make_assets/table_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace billiards::make_assets {

namespace {

using base::Vec2;
using base::Vec3;
using client::Mesh;

constexpr double kTile_m = 0.3;
constexpr double kSlateEdge_m = 0.012;  ///< How far the cloth is seen to go down into a pocket.

/// A line of a cushion's profile, seen from the side: how far behind the nose's outline and how
/// far above the nose's height it runs.
struct ProfileLine {
    double inset_m = 0.0;
    double above_m = 0.0;
};
/// The rounded nose, from below to above. No inset reaches a jaw's centre.
constexpr std::array<ProfileLine, 8> kNose{{{0.0020, -0.0048},
                                            {0.0012, -0.0032},
                                            {0.0003, -0.0014},
                                            {0.0, 0.0},
                                            {0.0002, 0.0010},
                                            {0.0007, 0.0019},
                                            {0.0014, 0.0025},
                                            {0.0022, 0.0028}}};
constexpr double kUndercut_m = 0.014;  ///< How far the rubber's foot lies behind its nose.
/// The shade under a nose reaches as far in front of it; over the cloth by less than a spot.
constexpr double kShade_m = 0.042;
constexpr double kShadeAboveCloth_m = 0.0002;

Vec2 behind(const EdgePoint& point, double inset_m) {
    return point.place_m + inset_m * point.normal;
}

/// How far a place lies behind the nose line, as a share of the rubber's width.
double depth_share(const RailPlan& rail, const Vec2& place) {
    return (glm::dot(rail.into, place) - rail.back_m) / rail.width_m + 1.0;
}

/// The facing at this end of the rail: a side pocket's is turned more than a corner's.
const EdgePoint& facing_beside(const RailPlan& rail, const EdgePoint& point) {
    const bool is_first = glm::dot(point.normal, rail.along) > 0;
    return is_first ? rail.nose.front() : rail.nose.back();
}

/// 1 where the outline faces the table, 0 at the facings, which have no undercut.
double facing_table(const RailPlan& rail, const EdgePoint& point) {
    const double at_facing = glm::dot(facing_beside(rail, point).normal, rail.into);
    return (glm::dot(point.normal, rail.into) - at_facing) / (1.0 - at_facing);
}

/// The direction of the facing at this end of the rail, as long as takes it one metre deep.
Vec2 along_facing(const RailPlan& rail, const EdgePoint& point) {
    const EdgePoint& facing = facing_beside(rail, point);
    const Vec2 outwards{-facing.normal.y, facing.normal.x};
    return outwards / glm::dot(outwards, rail.into);
}

/// The height of the rubber's top, which rises from the nose to the wood.
double top_m(const TablePlan& plan, const RailPlan& rail, const Vec2& place) {
    const double nose_top = plan.nose_height_m + kNose.back().above_m;
    const double share = std::clamp(depth_share(rail, place), 0.0, 1.0);
    return nose_top + share * (plan.top_height_m - nose_top);
}

/// The cloth runs along the rail, and v goes on over the profile, so that nothing is stretched.
Point cloth_point(const RailPlan& rail, const Vec3& place, double across_m) {
    return {place, Vec2(glm::dot(rail.along, base::horizontal(place)), across_m) / kTile_m};
}

/// Where the rubber meets the bed: undercut, and at the jaws by as much, along the facing.
Row foot_row(const RailPlan& rail) {
    Row row;
    for (auto point = rail.nose.rbegin(); point != rail.nose.rend(); ++point) {
        const bool is_end = point == rail.nose.rbegin() || point + 1 == rail.nose.rend();
        const double straight = facing_table(rail, *point);
        const Vec2 backwards = straight * rail.into + (1 - straight) * along_facing(rail, *point);
        const Vec2 foot =
            behind(*point, kNose.front().inset_m) + (is_end ? 0.0 : kUndercut_m) * backwards;
        row.push_back(cloth_point(rail, Vec3(foot, 0.0), 0.0));
    }
    return row;
}

Row nose_row(const TablePlan& plan, const RailPlan& rail, const ProfileLine& line) {
    const double height = plan.nose_height_m + line.above_m;
    Row row;
    for (auto point = rail.nose.rbegin(); point != rail.nose.rend(); ++point) {
        const double top = top_m(plan, rail, point->place_m) - kNose.back().above_m;
        const double z = line.above_m > 0 ? top + line.above_m : height;
        row.push_back(cloth_point(rail, Vec3(behind(*point, line.inset_m), z), height));
    }
    return row;
}

Row back_row(const TablePlan& plan, const RailPlan& rail, double height_m) {
    Row row;
    for (auto point = rail.nose.rbegin(); point != rail.nose.rend(); ++point) {
        const Vec2 place = glm::dot(rail.along, behind(*point, kNose.back().inset_m)) * rail.along +
                           rail.back_m * rail.into;
        const double across =
            plan.nose_height_m + rail.width_m * (1.0 - depth_share(rail, point->place_m));
        row.push_back(cloth_point(rail, Vec3(place, height_m), across));
    }
    return row;
}

void add_cushion(Mesh& mesh, const TablePlan& plan, const RailPlan& rail) {
    std::vector<Row> rows{foot_row(rail)};
    for (const ProfileLine& line : kNose) rows.push_back(nose_row(plan, rail, line));
    rows.push_back(back_row(plan, rail, plan.top_height_m));
    add_sheet(mesh, rows);
}

/// What is seen of a rubber from inside the pockets beside it.
void add_back(Mesh& mesh, const TablePlan& plan, const RailPlan& rail) {
    Row low = back_row(plan, rail, 0.0);
    Row high = back_row(plan, rail, plan.top_height_m);
    std::reverse(low.begin(), low.end());
    std::reverse(high.begin(), high.end());
    add_sheet(mesh, {low, high});
}

/// From the rubber's foot out over the bed, narrow where the outline turns into a pocket.
void add_shade(Mesh& mesh, const RailPlan& rail) {
    Row behind_nose;
    Row before_nose;
    for (auto point = rail.nose.rbegin(); point != rail.nose.rend(); ++point) {
        const double straight = std::max(0.0, facing_table(rail, *point));
        const auto place = [&](double inset_m) {
            return Vec3(point->place_m + inset_m * rail.into, kShadeAboveCloth_m);
        };
        behind_nose.push_back({place(straight * kUndercut_m), {0.5, 0.5}});
        before_nose.push_back({place(-straight * kShade_m), {0.5, 1.0}});
    }
    add_sheet(mesh, {before_nose, behind_nose});
}

Mesh bed_of(const TablePlan& plan) {
    Mesh mesh{.name = "bed", .vertices = {}, .indices = {}};
    Row outline;
    for (const Vec2& place : plan.bed) outline.push_back({Vec3(place, 0.0), place / kTile_m});
    add_plate(mesh, outline);
    return mesh;
}

/// The cloth over the slate's edge, seen from within the hole.
void add_lip(Mesh& mesh, const PocketPlan& pocket) {
    Row low;
    Row high;
    for (auto angle = pocket.cloth_arc_rad.rbegin(); angle != pocket.cloth_arc_rad.rend();
         ++angle) {
        const double r = pocket.hole.radius_m;
        const Vec2 place =
            pocket.hole.center_m + r * Vec2(base::cosine(*angle), base::sine(*angle));
        high.push_back({Vec3(place, 0.0), Vec2(*angle * r, 0.0) / kTile_m});
        low.push_back({Vec3(place, -kSlateEdge_m), Vec2(*angle * r, -kSlateEdge_m) / kTile_m});
    }
    add_sheet(mesh, {low, high});
}

}  // namespace

std::vector<Mesh> cloth_meshes(const model::TableSpec& table) {
    const TablePlan plan = plan_of(table);
    Mesh lips{.name = "lips", .vertices = {}, .indices = {}};
    for (const PocketPlan& pocket : plan.pockets) add_lip(lips, pocket);
    return {bed_of(plan), lips};
}

std::vector<Mesh> cushion_meshes(const model::TableSpec& table) {
    const TablePlan plan = plan_of(table);
    Mesh cushions{.name = "cushions", .vertices = {}, .indices = {}};
    Mesh backs{.name = "backs", .vertices = {}, .indices = {}};
    for (const RailPlan& rail : plan.rails) {
        add_cushion(cushions, plan, rail);
        add_back(backs, plan, rail);
    }
    return {cushions, backs};
}

std::vector<Mesh> shade_meshes(const model::TableSpec& table) {
    const TablePlan plan = plan_of(table);
    Mesh shade{.name = "shade", .vertices = {}, .indices = {}};
    for (const RailPlan& rail : plan.rails) add_shade(shade, rail);
    return {shade};
}

}  // namespace billiards::make_assets
