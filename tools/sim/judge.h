// Takes a rack, what was said and a shot's events; gives the verdict, as JSON.
#pragma once

#include "tools/sim/json_node.h"

namespace billiards::tools {

/// `billiards-sim judge`; docs/rules.md has the fields.
Json judge(const JsonNode& input, Fault& fault);

}  // namespace billiards::tools
