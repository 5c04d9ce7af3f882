// Takes a match; gives it with its balls racked, counted or put away: one rack after another until
// the race is won.
#pragma once

#include "common/match/match_state.h"
#include "common/model/seat.h"
#include "common/rules/verdict.h"

#include <optional>

namespace billiards::match {

/// What the rules know of the balls follows from where they lie.
void count_balls(MatchState& match);

/// Who breaks the first rack: always First in practice.
model::Seat first_breaker(const MatchState& match);

/// The rack of this number, fresh.
void rack_up(MatchState& match, model::Seat breaker);

/// The same rack once more: its points and its fouls in a row stay.
void rack_again(MatchState& match, model::Seat breaker);

/// At straight pool the rack goes on with its balls racked again, in another order each time; the
/// cue ball is taken in hand where it is in the way. None: nothing to do.
void rack_on(MatchState& match, rules::Rerack which);

/// The rack is won; the next one is racked, or the match is over.
void end_rack(MatchState& match, model::Seat winner);

/// None: a draw, or the end of practice.
void end_match(MatchState& match, std::optional<model::Seat> winner);

}  // namespace billiards::match
