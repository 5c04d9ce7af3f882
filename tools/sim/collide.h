// Takes a case of one collision; gives the balls after it, as JSON.
#pragma once

#include "tools/sim/json_node.h"

namespace billiards::tools {

/// `billiards-sim collide`; docs/physics.md has the fields.
Json collide(const JsonNode& input, Fault& fault);

}  // namespace billiards::tools
