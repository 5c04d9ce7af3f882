// Takes what somebody would be called; gives whether a server takes it.
#pragma once

#include "common/protocol/limits.h"

#include <string_view>

namespace billiards::client {

bool is_player_name(std::string_view name);

/// What to say where it is none.
inline constexpr std::string_view kPlayerNameRule = "a name has 1 to 24 letters or signs.";
static_assert(protocol::kMaxNameLength == 24);

}  // namespace billiards::client
