// Takes a step of a match; gives how the protocol calls it.
#pragma once

#include "common/match/command.h"
#include "common/protocol/server_messages.h"

namespace billiards::protocol {

/// Of a step that is told as MatchMoved: neither a shot nor the cue ball set down.
server::Move move_of(const match::Command& command);

/// How a match ended whose last step this was.
server::Ending ending_of(const match::Command& last);

}  // namespace billiards::protocol
