// Takes what a server would not do; gives the sentence that its asker reads.
#pragma once

#include "common/protocol/messages.h"

#include <string>

namespace billiards::client {

/// "the balls are still rolling": without a capital or a full stop, as every sentence of narrate.h.
/// What the server adds in its own words stands behind it where it says more.
std::string words(const protocol::server::Refused& refused);

}  // namespace billiards::client
