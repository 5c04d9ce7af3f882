// Takes the command line of a proof and what it does; gives the program's exit code.
#pragma once

#include "tests/soak/hall.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>

namespace billiards::soak {

/// Adds the options that every proof has, fills them and the app's own in, and writes what `proof`
/// then gives as a line of JSON. 1 where a promise was broken or something else was in the way.
int prove(CLI::App& app, int argc, const char* const* argv, HallOptions& hall,
          const std::function<nlohmann::ordered_json()>& proof);

}  // namespace billiards::soak
