// Takes a shot's timeline; gives the balls that are dropping into pockets, which the truth has
// already taken off the table. For the eye only.
#pragma once

#include "client/playback/playback.h"
#include "common/model/table_spec.h"
#include "common/timeline/timeline.h"

#include <vector>

namespace billiards::client {

/// Those that went into a pocket less than a moment before time_s: they go on as they came, held
/// within the pocket, and fall until they are out of sight. In ascending number.
std::vector<ShownBall> falling_balls(const timeline::Timeline& timeline,
                                     const model::TableSpec& table, double time_s);

}  // namespace billiards::client
