// Takes facts; gives fouls, as one table of conditions.
#include "common/rules/standard_fouls.h"

namespace billiards::rules {

namespace {

/// From behind the head string the cue ball must cross it, or meet a ball on or over it, before it
/// touches a ball behind it.
bool is_head_string_foul(const RackState& state, const Facts& facts) {
    return state.in_hand == Zone::BehindHeadString && !facts.crossed_head_string &&
           !facts.first_contacts.empty() &&
           (facts.first_contacts - state.behind_head_string).empty();
}

}  // namespace

std::vector<Foul> standard_fouls(const RackState& state, model::BallSet legal_first_balls,
                                 const Facts& facts) {
    const bool hit = !facts.first_contacts.empty();
    const bool hit_legal = !(facts.first_contacts & legal_first_balls).empty();
    struct Condition {
        bool holds;
        Foul foul;
    };
    const Condition conditions[] = {
        {facts.cue_ball_lost, Foul::Scratch},
        {!hit, Foul::NoBallHit},
        {hit && !hit_legal, Foul::WrongBallFirst},
        {hit && facts.driven_after_contact.empty(), Foul::NoCushionAfterContact},
        {!facts.off_table.empty(), Foul::BallOffTable},
        {is_head_string_foul(state, facts), Foul::HeadString},
    };
    std::vector<Foul> fouls;
    for (const Condition& condition : conditions) {
        if (condition.holds) fouls.push_back(condition.foul);
    }
    return fouls;
}

}  // namespace billiards::rules
