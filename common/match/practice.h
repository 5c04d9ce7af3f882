// Takes a match of practice; gives it with the balls where its player wants them.
#pragma once

#include "common/match/match_state.h"

namespace billiards::match {

/// Keeps the position for undo, and forgets the oldest beyond kMostUndone.
void remember(MatchState& match);

/// Back to the position that was remembered last; there is one.
void undo(MatchState& match);
/// As everybody is told it: without what lies behind an undo.
MatchState as_told(MatchState match);

/// Back to the position before the last shot; there was one.
void repeat(MatchState& match);

/// Onto the table, wherever the ball was.
void place_ball(MatchState& match, const PlaceBall& command);

}  // namespace billiards::match
