// Takes a layout and a wish; gives where a ball may lie: cue ball in hand, and spotted balls.
#pragma once

#include "common/base/result.h"
#include "common/base/vec.h"
#include "common/match/refusal.h"
#include "common/model/ball.h"
#include "common/model/layout.h"
#include "common/model/table_spec.h"
#include "common/rules/verdict.h"

#include <span>

namespace billiards::match {

/// Whether the ball may be set down at `position_m`: inside the cushions, in the zone (its centre
/// strictly behind the head string where the zone says so), over no pocket, and touching at most,
/// overlapping never, another ball.
Result<base::Done> check_placement(const model::TableSpec& table, const model::Layout& layout,
                                   rules::Zone zone, base::Vec2 position_m,
                                   model::BallId ball = model::kCueBall);

/// A free place in the zone to start from: on the long string, as near to the head spot as can be.
base::Vec2 default_placement(const model::TableSpec& table, const model::Layout& layout,
                             rules::Zone zone);

/// Spots balls in ascending number: on the foot spot, else as near as possible behind it on the
/// long string (touching the ball in the way, but never the cue ball), else in front of it.
/// WPA 1.4.
void spot_balls(const model::TableSpec& table, model::Layout& layout,
                std::span<const model::BallId> balls);

/// Spots the one of `balls`, all on the table, that is nearest to the head string.
void spot_nearest(const model::TableSpec& table, model::Layout& layout, model::BallSet balls);

/// The object balls on the table whose centres lie behind the head string.
model::BallSet balls_behind_head_string(const model::TableSpec& table, const model::Layout& layout);

}  // namespace billiards::match
