// Takes a replay; gives the match as text, shot by shot, to be read like the score of a chess game.
#pragma once

#include "common/replay/replay.h"

#include <iosfwd>

namespace billiards::tools {

/// Who played what and when; rack by rack a numbered line a shot; and how it ended, if it did.
/// Where an entry does not follow from those before it, the text ends there, with the fault.
replay::Result<base::Done> print_score(const replay::Replay& replay, std::ostream& out);

}  // namespace billiards::tools
