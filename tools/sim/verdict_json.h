// Takes a verdict; gives it as JSON.
#pragma once

#include "common/rules/verdict.h"
#include "tools/sim/json_node.h"

namespace billiards::tools {

/// The fields of docs/rules.md, in its order.
Json json_of(const rules::Verdict& verdict);

}  // namespace billiards::tools
