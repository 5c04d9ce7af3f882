// Gives racks of nine- and ten-ball to shoot at; the first seat shoots.
#pragma once

#include "common/rules/ruleset.h"
#include "tests/common/rules/told_shot.h"

namespace billiards::rules {

inline const model::BallSet kNineBalls = model::BallSet::from_bits(0x03FE);
inline const model::BallSet kTenBalls = model::BallSet::from_bits(0x07FE);

inline RackState before_break_of(model::BallSet on_table) {
    RackState state;
    state.on_table = on_table;
    state.in_hand = Zone::BehindHeadString;
    return state;
}

/// The ordinary phase: no push-out any more.
inline RackState with_balls(model::BallSet on_table) {
    RackState state = before_break_of(on_table);
    state.phase = Phase::Groups;
    state.in_hand = Zone::None;
    return state;
}

inline RackState after_break_of(model::BallSet on_table) {
    RackState state = with_balls(on_table);
    state.phase = Phase::AfterBreak;
    state.push_out_allowed = true;
    return state;
}

/// Hits the 1 and drives that many object balls to cushions, the 1 first.
inline ToldShot break_driving(int object_balls) {
    ToldShot shot;
    shot.hits(1);
    for (int ball = 1; ball <= object_balls; ++ball) shot.cushion(ball);
    return shot;
}

}  // namespace billiards::rules
