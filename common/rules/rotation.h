// Takes shots at the games that are played from the lowest ball up; gives what nine- and ten-ball
// share: the break, the push-out and three fouls in a row.
#pragma once

#include "common/model/ball.h"
#include "common/model/shot.h"
#include "common/rules/facts.h"
#include "common/rules/ruling.h"
#include "common/rules/verdict.h"

#include <vector>

namespace billiards::rules {

/// The one ball that must be hit first; empty where none is on the table.
model::BallSet lowest_ball(model::BallSet on_table);

/// Whether this shot is the push-out that `call` says. One that may not be said is none.
bool is_push_out(const RackState& state, const model::Call& call);

/// Verdict of a shot. The shared rulings rank first: the third foul in a row, a foul, a push-out;
/// then `rulings`, the game's own for a shot without a foul. `key_ball`, with which the rack is
/// won, is spotted where it went down and did not win; no other ball ever is.
Verdict rotation_verdict(const RackState& state, const model::Call& call, const Facts& facts,
                         model::BallId key_ball, const std::vector<Ruling>& rulings);

/// A foul with the cue ball in hand anywhere; before the break, the other player breaks.
Verdict rotation_timeout(const RackState& state);

/// What follows when the opponent plays on, or has the other do so.
Resolution rotation_resolution(const Verdict& verdict, Choice choice);

}  // namespace billiards::rules
