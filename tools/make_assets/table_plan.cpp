// Takes noses, facings, jaws and pockets; gives the outlines that run through exactly them.
#include "tools/make_assets/table_plan.h"

#include "common/base/check.h"
#include "common/base/elementary.h"
#include "common/model/shot.h"

#include <algorithm>
#include <cmath>

namespace billiards::make_assets {

namespace {

using base::Vec2;
using model::TableSpec;

constexpr std::size_t kRails = model::kPockets;
constexpr double kInch_m = 0.0254;
constexpr double kTopAboveNose_m = 0.007;
constexpr double kCornerRadius_m = 0.075;              ///< Of the outer rail.
constexpr double kSightFromNose_m = 3.6875 * kInch_m;  ///< WPA Equipment Specifications, 5.

Vec2 direction(double angle_rad) {
    return {base::cosine(angle_rad), base::sine(angle_rad)};
}

double angle_of(const Vec2& v) {
    return base::arc_tangent(v.y, v.x);
}

/// Angles from one direction to another, the short way round.
std::vector<double> arc_between(double from_rad, double to_rad, int pieces) {
    double sweep = to_rad - from_rad;
    if (sweep > base::kPi) sweep -= 2 * base::kPi;
    if (sweep < -base::kPi) sweep += 2 * base::kPi;
    std::vector<double> angles;
    for (int i = 0; i <= pieces; ++i) angles.push_back(from_rad + sweep * i / pieces);
    return angles;
}

/// Straight away from the table: the line on which two boards meet.
Vec2 cut_direction(const Vec2& pocket) {
    const double x = std::fabs(pocket.x) < 1e-9 ? 0.0 : (pocket.x > 0 ? 1.0 : -1.0);
    return glm::normalize(Vec2(x, pocket.y > 0 ? 1.0 : -1.0));
}

/// Where the line of a rubber's back leaves the circle around a pocket. side: -1 for the pocket
/// where the rail starts, +1 where it ends.
Vec2 leaving_circle(const RailPlan& rail, const Vec2& center, double radius_m, double side) {
    const double off = rail.back_m - glm::dot(rail.into, center);
    CHECK(std::fabs(off) < radius_m);
    const double half_chord = std::sqrt(radius_m * radius_m - off * off);
    return center + off * rail.into - side * half_chord * rail.along;
}

/// From a facing round the jaw to the nose: points and normals.
void add_jaw(Edge& edge, const model::JawArc& jaw, const Vec2& from, const Vec2& to) {
    constexpr int kPieces = 6;
    for (const double angle :
         arc_between(angle_of(from - jaw.center_m), angle_of(to - jaw.center_m), kPieces)) {
        const Vec2 outwards = direction(angle);
        edge.push_back({jaw.center_m + jaw.radius_m * outwards, -outwards});
    }
    // The ends to the bit, not but for rounding.
    edge[edge.size() - kPieces - 1].place_m = from;
    edge.back().place_m = to;
}

Edge nose_of(const TableSpec& table, std::size_t rail) {
    const model::CushionSegment& nose = table.cushions[rail];
    const model::CushionSegment& first = table.cushions[kRails + 2 * rail];
    const model::CushionSegment& last = table.cushions[kRails + 2 * rail + 1];
    Edge edge{{first.to_m, {}}};
    add_jaw(edge, table.jaws[2 * rail], first.from_m, nose.from_m);
    add_jaw(edge, table.jaws[2 * rail + 1], nose.to_m, last.from_m);
    edge.front().normal = edge[1].normal;
    edge.push_back({last.to_m, edge.back().normal});
    return edge;
}

/// Half an outer corner, from direction to direction; where the cut is straight, one point.
void add_corner(Edge& edge, const Vec2& half_outer, const Vec2& cut, double from, double to) {
    constexpr int kPieces = 6;
    const Vec2 center = glm::sign(cut) * (half_outer - kCornerRadius_m);
    for (const double angle : arc_between(from, to, kPieces)) {
        edge.push_back({center + kCornerRadius_m * direction(angle), direction(angle)});
    }
}

Edge outer_of(const TableSpec& table, const RailPlan& rail, const Vec2& first_cut,
              const Vec2& last_cut) {
    Edge edge;
    const double straight = angle_of(rail.into);
    const auto add = [&](const Vec2& cut, double from, double to) {
        if (cut.x == 0.0) {
            edge.push_back({{0.0, cut.y * table.half_outer_m.y}, rail.into});
        } else {
            add_corner(edge, table.half_outer_m, cut, from, to);
        }
    };
    add(first_cut, angle_of(first_cut), straight);
    add(last_cut, straight, angle_of(last_cut));
    return edge;
}

std::vector<Vec2> inner_of(const TableSpec& table, const RailPlan& rail, std::size_t i) {
    constexpr int kPieces = 14;
    std::vector<Vec2> inner;
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const model::PocketCircle& pocket = table.pockets[(i + end) % kRails];
        const double radius = pocket.radius_m + kLiner_m;
        const double cut = angle_of(cut_direction(pocket.center_m));
        const double back = angle_of(
            leaving_circle(rail, pocket.center_m, radius, end == 0 ? -1 : 1) - pocket.center_m);
        for (const double angle :
             end == 0 ? arc_between(cut, back, kPieces) : arc_between(back, cut, kPieces)) {
            inner.push_back(pocket.center_m + radius * direction(angle));
        }
    }
    return inner;
}

RailPlan rail_of(const TableSpec& table, std::size_t i) {
    RailPlan rail;
    const model::CushionSegment& nose = table.cushions[i];
    rail.along = glm::normalize(nose.to_m - nose.from_m);
    rail.into = {rail.along.y, -rail.along.x};
    rail.back_m = glm::dot(rail.into, table.cushions[kRails + 2 * i].to_m);
    rail.width_m = rail.back_m - glm::dot(rail.into, nose.from_m);
    rail.nose = nose_of(table, i);
    rail.outer = outer_of(table, rail, cut_direction(table.pockets[i].center_m),
                          cut_direction(table.pockets[(i + 1) % kRails].center_m));
    rail.inner = inner_of(table, rail, i);
    return rail;
}

/// Anticlockwise from one direction through another to a third.
std::vector<double> arc_through(double from, double middle, double to) {
    constexpr int kPieces = 20;
    std::vector<double> angles = arc_between(from, middle, kPieces);
    const std::vector<double> rest = arc_between(middle, to, kPieces);
    angles.insert(angles.end(), rest.begin() + 1, rest.end());
    return angles;
}

/// From the hole to the outer edge, across the boards beside it.
double wood_beside(const TableSpec& table, const model::PocketCircle& hole) {
    const Vec2 left = table.half_outer_m - glm::abs(hole.center_m) - hole.radius_m;
    return std::min(left.x, left.y);
}

PocketPlan pocket_of(const TableSpec& table, const std::vector<RailPlan>& rails, std::size_t i) {
    const model::PocketCircle& hole = table.pockets[i];
    const RailPlan& before = rails[(i + kRails - 1) % kRails];
    const RailPlan& after = rails[i];
    const Vec2 outwards = cut_direction(hole.center_m);
    const auto leaving = [&](const RailPlan& rail, double radius, double side) {
        return angle_of(leaving_circle(rail, hole.center_m, radius, side) - hole.center_m);
    };
    const double wood = hole.radius_m + kLiner_m;
    return {hole,
            arc_through(leaving(before, wood, 1), angle_of(outwards), leaving(after, wood, -1)),
            arc_through(leaving(after, hole.radius_m, -1), angle_of(-outwards),
                        leaving(before, hole.radius_m, 1)),
            wood_beside(table, hole)};
}

std::vector<Vec2> bed_of(const std::vector<PocketPlan>& pockets) {
    std::vector<Vec2> bed;
    for (const PocketPlan& pocket : pockets) {
        // The hole's edge is walked backwards: it is a bay in the cloth.
        for (auto angle = pocket.cloth_arc_rad.rbegin(); angle != pocket.cloth_arc_rad.rend();
             ++angle) {
            bed.push_back(pocket.hole.center_m + pocket.hole.radius_m * direction(*angle));
        }
    }
    return bed;
}

/// Eighths of the length on the long rails, quarters of the width on the short ones.
std::vector<Vec2> sights_of(const TableSpec& table, const std::vector<RailPlan>& rails) {
    const Vec2 half = table.half_playing_m;
    std::vector<Vec2> sights;
    for (const RailPlan& rail : rails) {
        const bool is_short = std::fabs(rail.along.x) < 0.5;
        const double spacing = is_short ? half.y / 2 : half.x / 4;
        const Vec2 middle =
            is_short ? Vec2(0.0) : Vec2(glm::sign(rail.nose[1].place_m.x) * half.x / 2, 0.0);
        for (const int step : {-1, 0, 1}) {
            sights.push_back(middle + step * spacing * rail.along +
                             (rail.back_m - rail.width_m + kSightFromNose_m) * rail.into);
        }
    }
    return sights;
}

}  // namespace

TablePlan plan_of(const TableSpec& table) {
    CHECK(table.pockets.size() == kRails && table.cushions.size() == 3 * kRails &&
          table.jaws.size() == 2 * kRails);
    TablePlan plan;
    for (std::size_t i = 0; i < kRails; ++i) plan.rails.push_back(rail_of(table, i));
    for (std::size_t i = 0; i < kRails; ++i) {
        plan.pockets.push_back(pocket_of(table, plan.rails, i));
    }
    plan.bed = bed_of(plan.pockets);
    plan.sights = sights_of(table, plan.rails);
    plan.nose_height_m = table.nose_height_m;
    plan.top_height_m = table.nose_height_m + kTopAboveNose_m;
    return plan;
}

}  // namespace billiards::make_assets
