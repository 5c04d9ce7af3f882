// Gives racks of eight-ball to shoot at; the first seat shoots, and has the solids where groups
// are set.
#pragma once

#include "common/rules/games.h"
#include "tests/common/rules/told_shot.h"

#include <initializer_list>

namespace billiards::rules {

inline RackState at_break() {
    RackState state;
    state.shooter = kShooter;
    state.on_table = model::BallSet::from_bits(0xFFFE);
    state.in_hand = Zone::BehindHeadString;
    return state;
}

inline RackState open_without(model::BallSet gone) {
    RackState state = at_break();
    state.phase = Phase::Open;
    state.in_hand = Zone::None;
    state.on_table = state.on_table - gone;
    return state;
}

inline model::PerSeat<Group> shooter_has(Group group) {
    const Group other = group == Group::Solids ? Group::Stripes : Group::Solids;
    return {{group, other}};
}

inline RackState solids_without(model::BallSet gone) {
    RackState state = open_without(gone);
    state.phase = Phase::Groups;
    state.groups = shooter_has(Group::Solids);
    return state;
}

inline const model::BallSet kAllSolids = model::BallSet::from_bits(0x00FE);
inline const model::BallSet kAllStripes = model::BallSet::from_bits(0xFE00);

inline Verdict judged(const RackState& state, const model::Call& said, const ToldShot& shot,
                      const Options& options = {}) {
    return eight_ball().judge(state, options, said, shot.facts());
}

}  // namespace billiards::rules
