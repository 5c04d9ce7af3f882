// Takes what was said before a shot; gives whether it may be said, and whether it was made.
#pragma once

#include "common/model/ball.h"
#include "common/model/shot.h"
#include "common/rules/facts.h"

#include <optional>

namespace billiards::rules {

/// Whether `call` is a safety, or one of `balls` in a pocket that exists.
bool is_shot_call(model::BallSet balls, const model::Call& call);

/// The called ball, if it is one of `balls` and fell into its pocket.
std::optional<model::BallId> called_ball_down(model::BallSet balls, const model::Call& call,
                                              const Facts& facts);

}  // namespace billiards::rules
