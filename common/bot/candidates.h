// Takes a layout; gives the straight pots that can be seen from a place: cue ball to object ball to
// pocket with nothing in the way.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"
#include "common/model/layout.h"
#include "common/model/shot.h"
#include "common/model/table_spec.h"

#include <vector>

namespace billiards::bot {

/// The object ball leaves along the line of centres, so the cue ball must arrive at the "ghost
/// ball": the place where it touches the object ball opposite to where that shall go.
struct Pot {
    model::BallId ball;
    model::PocketId pocket;
    base::Vec2 ball_m{};
    base::Vec2 towards{};  ///< Unit vector from the object ball into the pocket.
    double ball_path_m = 0.0;
    double cue_path_m = 0.0;
    double cut_cosine = 1.0;  ///< Of the angle between the two paths: 1 is a full hit.
    double margin_rad = 0.0;  ///< How far the aim may be off: the larger, the easier.
};

/// Where the cue must point for a cue ball at `cue_ball_m`.
double aim_rad(base::Vec2 cue_ball_m, const Pot& pot);

/// All pots of `targets` from `cue_ball_m`, easiest first.
std::vector<Pot> pots_from(const model::TableSpec& table, const model::Layout& layout,
                           model::BallSet targets, base::Vec2 cue_ball_m);

/// Places from which a ball of `targets` goes straight into a pocket. Some may be blocked, outside
/// the cushions or outside the zone.
std::vector<base::Vec2> straight_in_places(const model::TableSpec& table,
                                           const model::Layout& layout, model::BallSet targets);

/// Whether a ball can roll from one place to the other without meeting an object ball but
/// `except`.
bool is_path_clear(const model::Layout& layout, base::Vec2 from_m, base::Vec2 to_m,
                   model::BallId except);

}  // namespace billiards::bot
