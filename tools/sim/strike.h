// Takes a case of a cue and a ball; gives the ball's motion as the tip leaves it, as JSON.
#pragma once

#include "tools/sim/json_node.h"

namespace billiards::tools {

/// `billiards-sim strike`; docs/physics.md has the fields.
Json strike(const JsonNode& input, Fault& fault);

}  // namespace billiards::tools
