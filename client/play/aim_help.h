// Takes a shot before it is played; gives where its first contact would be, by the engine itself:
// with spin, squirt and all.
#pragma once

#include "common/base/vec.h"
#include "common/match/match_state.h"
#include "common/model/shot.h"

#include <optional>
#include <vector>

namespace billiards::client {

struct AimHelp {
    std::vector<base::Vec2> cue_ball_way_m;  ///< Of its centre, to the first contact or rest.
    /// Where the cue ball is as it meets a ball; none where it meets none.
    std::optional<base::Vec2> ghost_ball_m;
    base::Vec2 object_ball_m{};
    base::Vec2 object_ball_way{};  ///< Of length 1: where the object ball sets out to.
};

/// The cue ball lies at `cue_ball_m`, wherever the match has it. None where the engine does not
/// take the shot or the place.
std::optional<AimHelp> aim_help(const match::MatchState& match, base::Vec2 cue_ball_m,
                                const model::Shot& shot);

}  // namespace billiards::client
