// Gives the name of what solves and judges shots.
#pragma once

#include <string_view>

namespace billiards::replay {

/// Raised whenever a shot that was played would be solved or judged otherwise today, by one bit or
/// one word: matches of the version before still play, but can no longer be verified.
/// tests/golden/replays has a match of every version, and fails when this one was forgotten.
inline constexpr std::string_view kEngineVersion = "1";

}  // namespace billiards::replay
