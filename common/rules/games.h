// Gives the rules of every game, one file each: World Standardized Rules (WPA, 2016), by the part
// that is named. Each is valid for the whole program.
#pragma once

#include "common/rules/ruleset.h"

namespace billiards::rules {

const Ruleset& eight_ball();     ///< Part 3.
const Ruleset& nine_ball();      ///< Part 2.
const Ruleset& ten_ball();       ///< Part 9.
const Ruleset& straight_pool();  ///< Part 4: 14.1 continuous.
const Ruleset& practice();       ///< One player alone, and nobody judged.

}  // namespace billiards::rules
