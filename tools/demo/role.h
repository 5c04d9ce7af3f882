// Takes one role at a server; plays or watches a match to its end.
#pragma once

#include "tools/demo/options.h"

namespace billiards::tools {

/// Gives the exit code: 0 where the match was seen to its end.
int play_role(const RoleOptions& options);

}  // namespace billiards::tools
