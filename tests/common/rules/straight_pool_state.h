// Gives racks of straight pool to shoot at; the first seat shoots.
#pragma once

#include "common/rules/games.h"
#include "tests/common/rules/told_shot.h"

namespace billiards::rules {

inline RackState opening() {
    RackState state;
    state.on_table = model::BallSet::from_bits(0xFFFE);
    state.in_hand = Zone::BehindHeadString;
    return state;
}

inline RackState in_play(model::BallSet on_table = opening().on_table) {
    RackState state = opening();
    state.phase = Phase::Groups;
    state.in_hand = Zone::None;
    state.on_table = on_table;
    return state;
}

inline RackState with_score(RackState state, int of_shooter, int of_other = 0) {
    state.scores = {{of_shooter, of_other}};
    return state;
}

}  // namespace billiards::rules
