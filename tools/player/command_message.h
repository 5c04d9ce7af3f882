// Takes a command for a match; gives the message that asks a server for it.
#pragma once

#include "common/match/command.h"
#include "common/protocol/messages.h"

#include <cstdint>

namespace billiards::tools {

/// `turn` is for commands that name none on their own, `shot_id` for shots. Not for what only a
/// table may say: Timeout and Forfeit.
protocol::ClientMessageBody message_of(const match::Command& command, model::TurnNumber turn,
                                       std::uint64_t shot_id);

}  // namespace billiards::tools
