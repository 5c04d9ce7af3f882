// Takes the table after a shot of straight pool that left one ball or none; gives it with the
// others racked again. WPA part 4, special racking situations.
#pragma once

#include "common/base/random.h"
#include "common/base/vec.h"
#include "common/model/layout.h"
#include "common/model/table_spec.h"
#include "common/rules/verdict.h"

namespace billiards::match {

/// Whether a ball that lies there touches the outline of the rack, or is within it: the triangle
/// that is tight around fifteen balls.
bool is_in_rack(const model::TableSpec& table, base::Vec2 position_m);

/// Fifteen: racks every object ball, wherever it is. Fourteen: racks those that are down, with the
/// apex free, and moves the fifteenth or the cue ball out of the way; one object ball is on the
/// table. Gives the zone that the cue ball is then in hand in; None where it has its place, or was
/// in hand before.
rules::Zone rerack(const model::TableSpec& table, model::Layout& layout, rules::Rerack which,
                   base::Random& random);

}  // namespace billiards::match
