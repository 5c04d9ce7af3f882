// Takes a case of two accelerated balls; gives when they meet, as JSON.
#pragma once

#include "tools/sim/json_node.h"

namespace billiards::tools {

/// `billiards-sim contact-time`; docs/physics.md has the fields.
Json contact_time(const JsonNode& input, Fault& fault);

}  // namespace billiards::tools
