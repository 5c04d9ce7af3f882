// Takes the facts of a shot and the balls it had to meet; gives the fouls that all games share.
#pragma once

#include "common/model/ball.h"
#include "common/rules/facts.h"
#include "common/rules/verdict.h"

#include <vector>

namespace billiards::rules {

/// In the order of the enum, each once. Where nothing was hit there is no "after the contact", so
/// NoBallHit comes without NoCushionAfterContact. Of several first contacts at one instant, the
/// one that is legal counts.
std::vector<Foul> standard_fouls(const RackState& state, model::BallSet legal_first_balls,
                                 const Facts& facts);

}  // namespace billiards::rules
