// Takes a case of balls on a table; gives what happens, as JSON.
#pragma once

#include "tools/sim/json_node.h"

namespace billiards::tools {

/// `billiards-sim solve`; docs/physics.md has the fields.
Json solve(const JsonNode& input, Fault& fault);

}  // namespace billiards::tools
