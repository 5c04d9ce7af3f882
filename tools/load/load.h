// Takes options; makes the load and gives what was measured.
#pragma once

#include "tools/load/options.h"

#include <nlohmann/json.hpp>

namespace billiards::tools {

/// Runs on the calling thread until the time is over, or SIGINT or SIGTERM ends it early. Says on
/// standard error where fewer connections than asked are possible.
nlohmann::ordered_json make_load(LoadOptions options);

}  // namespace billiards::tools
