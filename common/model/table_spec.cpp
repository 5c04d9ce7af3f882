// Takes the WPA equipment specification's numbers; gives the three tables as segments, arcs and
// circles.
#include "common/model/table_spec.h"

#include "common/base/elementary.h"

#include <cmath>

namespace billiards::model {

namespace {

using base::Vec2;

constexpr double kInch_m = 0.0254;

/// How a cushion ends at a pocket: WPA Equipment Specifications 6 - 9, the middle of each range.
struct PocketCut {
    double mouth_m;     ///< Between the noses' ends.
    double facing_rad;  ///< How far the facing turns away from the nose line.
    double shelf_m;     ///< From the mouth to the drop edge.
};

constexpr PocketCut kCorner{4.5625 * kInch_m, base::radians(180.0 - 142.0), 1.625 * kInch_m};
constexpr PocketCut kSide{5.0625 * kInch_m, base::radians(180.0 - 104.0), 0.1875 * kInch_m};
constexpr double kJawRadius_m = 0.0025;  ///< 2 - 3 mm where nothing better is known.
constexpr double kCushionWidth_m = 1.9375 * kInch_m;
constexpr double kRailWidth_m = 5.75 * kInch_m;
constexpr double kNoseHeightOverDiameter = 0.635;

/// One end of a rail: the nose line runs along `along` (a unit vector) to `tip`, where the facing
/// would cut it if nothing were rounded; `into` points into the rubber.
struct RailEnd {
    Vec2 along{};
    Vec2 into{};
    Vec2 tip{};
    const PocketCut* cut = nullptr;
};

double tangent_length(const PocketCut& cut) {
    const double half = cut.facing_rad / 2;
    return kJawRadius_m * base::sine(half) / base::cosine(half);
}

Vec2 nose_end(const RailEnd& end) {
    return end.tip - tangent_length(*end.cut) * end.along;
}

JawArc jaw(const RailEnd& end) {
    return {nose_end(end) + kJawRadius_m * end.into, kJawRadius_m};
}

CushionSegment facing(const RailEnd& end) {
    const double sine = base::sine(end.cut->facing_rad);
    const Vec2 direction = base::cosine(end.cut->facing_rad) * end.along + sine * end.into;
    return {end.tip + tangent_length(*end.cut) * direction,
            end.tip + (kCushionWidth_m / sine) * direction};
}

struct Rail {
    RailEnd start;
    RailEnd end;
};

/// The rails from pocket 0 to 1, 1 to 2 and 2 to 3: the other three are these, turned by half a
/// turn, to the bit.
std::vector<Rail> half_the_rails(Vec2 half) {
    const double corner = kCorner.mouth_m / std::sqrt(2.0);
    const double side = kSide.mouth_m / 2;
    const Vec2 right{1, 0};
    const Vec2 up{0, 1};
    return {
        {{-right, -up, {-half.x + corner, -half.y}, &kCorner},
         {right, -up, {-side, -half.y}, &kSide}},
        {{-right, -up, {side, -half.y}, &kSide},
         {right, -up, {half.x - corner, -half.y}, &kCorner}},
        {{-up, right, {half.x, -half.y + corner}, &kCorner},
         {up, right, {half.x, half.y - corner}, &kCorner}},
    };
}

/// Pockets 0, 1 and 2: likewise. The drop edge lies a shelf behind the middle of the mouth.
std::vector<PocketCircle> half_the_pockets(Vec2 half) {
    const double corner_radius = kCorner.mouth_m / 2;
    const double side_radius = kSide.mouth_m / 2;
    const double mouth_middle = kCorner.mouth_m / std::sqrt(2.0) / 2;
    const double outward = (kCorner.shelf_m + corner_radius) / std::sqrt(2.0) - mouth_middle;
    return {{{-half.x - outward, -half.y - outward}, corner_radius},
            {{0.0, -half.y - kSide.shelf_m - side_radius}, side_radius},
            {{half.x + outward, -half.y - outward}, corner_radius}};
}

CushionSegment turned(const CushionSegment& segment) {
    return {-segment.from_m, -segment.to_m};
}

/// Noses 0 - 5 anticlockwise from pocket 0, then the facings: 6 + 2 i + (0 start, 1 end) of rail
/// i; jaws are numbered 2 i + (0 start, 1 end).
TableSpec build(Vec2 playing_size_m) {
    const Vec2 half = playing_size_m / 2.0;
    TableSpec table;
    const std::vector<Rail> rails = half_the_rails(half);
    for (const Rail& rail : rails)
        table.cushions.push_back({nose_end(rail.start), nose_end(rail.end)});
    for (std::size_t i = 0; i < 3; ++i) table.cushions.push_back(turned(table.cushions[i]));
    for (const Rail& rail : rails) {
        table.cushions.push_back(facing(rail.start));
        table.cushions.push_back(facing(rail.end));
        table.jaws.push_back(jaw(rail.start));
        table.jaws.push_back(jaw(rail.end));
    }
    for (std::size_t i = 0; i < 6; ++i) {
        table.cushions.push_back(turned(table.cushions[6 + i]));
        table.jaws.push_back({-table.jaws[i].center_m, table.jaws[i].radius_m});
    }
    table.pockets = half_the_pockets(half);
    for (std::size_t i = 0; i < 3; ++i) {
        table.pockets.push_back({-table.pockets[i].center_m, table.pockets[i].radius_m});
    }
    table.nose_height_m = kNoseHeightOverDiameter * 2 * BallSpec{}.radius_m;
    table.half_playing_m = half;
    table.half_outer_m = half + kRailWidth_m;
    table.head_string_m = -half.x / 2;
    return table;
}

}  // namespace

const TableSpec& table_of(TableSize size) {
    static const TableSpec seven_foot = build({1.98, 0.99});
    static const TableSpec eight_foot = build({2.24, 1.12});
    static const TableSpec nine_foot = build({2.54, 1.27});
    switch (size) {
        case TableSize::SevenFoot:
            return seven_foot;
        case TableSize::EightFoot:
            return eight_foot;
        case TableSize::NineFoot:
            return nine_foot;
    }
    CHECK(false);
}

TableSpec open_table() {
    return {};
}

base::Vec2 foot_spot(const TableSpec& table) {
    return {table.half_playing_m.x / 2, 0.0};
}

base::Vec2 head_spot(const TableSpec& table) {
    return {-table.half_playing_m.x / 2, 0.0};
}

}  // namespace billiards::model
