// Takes options; plays a whole match over four processes and tells it.
#pragma once

#include "tools/demo/options.h"

#include <filesystem>

namespace billiards::tools {

/// `self`: this program, which is started again for each role. Gives the exit code: 0 where the
/// match was played and the three who saw it agree on every shot; 128 + the signal where one
/// ended it.
int play_demo(const DemoOptions& options, const std::filesystem::path& self);

}  // namespace billiards::tools
