// Gives a table as data: what the balls meet, and the marks the rules speak of. The physics and
// the drawn table are both built from it.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace billiards::model {

/// A straight piece of cushion nose, as the line that a ball's surface touches at nose height.
struct CushionSegment {
    base::Vec2 from_m{};
    base::Vec2 to_m{};

    friend bool operator==(const CushionSegment&, const CushionSegment&) = default;
};

/// The rounded end of a cushion: a ball's centre turns back at radius_m + its own radius.
struct JawArc {
    base::Vec2 center_m{};
    double radius_m = 0.0;

    friend bool operator==(const JawArc&, const JawArc&) = default;
};

/// A ball is pocketed when its centre enters this circle.
struct PocketCircle {
    base::Vec2 center_m{};
    double radius_m = 0.0;

    friend bool operator==(const PocketCircle&, const PocketCircle&) = default;
};

/// The order is part of the wire format; only append.
enum class TableSize : std::uint8_t { SevenFoot, EightFoot, NineFoot };

/// A table. The origin is the centre of the playing surface, x runs along the long axis from the
/// head (-x) to the foot (+x), y across, z up. A jaw arc belongs to the segment ends its circle
/// passes within 1e-6 m of; a segment's end without an arc is an arc of radius 0.
struct TableSpec {
    std::vector<CushionSegment> cushions;
    std::vector<JawArc> jaws;
    std::vector<PocketCircle> pockets;  ///< In PocketId order on the named tables.
    double nose_height_m = 0.0;         ///< Of the cushions' contact line above the slate.
    /// Half the size between the noses, and of the outer rail's edge beyond which a ball is off
    /// the table. Zero playing size: a table without bed marks (given as data, or open).
    base::Vec2 half_playing_m{};
    base::Vec2 half_outer_m{};
    base::Vec2 center_m{};  ///< Of the outer rectangle; the origin on the named tables.
    /// x of the head string; none where the table has no marks.
    std::optional<double> head_string_m;

    friend bool operator==(const TableSpec&, const TableSpec&) = default;
};

/// The three tables of the WPA equipment specification. Built once each; valid for the whole
/// program.
const TableSpec& table_of(TableSize size);

/// No cushions, no pockets, no edge: for experiments.
TableSpec open_table();

/// On the long string, half way between the centre and the foot (head) cushion.
base::Vec2 foot_spot(const TableSpec& table);
base::Vec2 head_spot(const TableSpec& table);

}  // namespace billiards::model
