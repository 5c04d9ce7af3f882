// Takes the facts of a shot at nine- or ten-ball; gives the rulings that both games share.
#include "common/rules/rotation.h"

#include "common/base/check.h"
#include "common/rules/standard_fouls.h"

#include <algorithm>
#include <utility>

namespace billiards::rules {

namespace {

using model::BallSet;
using model::Seat;

constexpr int kBallsToCushionsOnBreak = 4;
constexpr int kFoulsThatLose = 3;

bool is_waived_by_push_out(Foul foul) {
    return foul == Foul::NoBallHit || foul == Foul::WrongBallFirst ||
           foul == Foul::NoCushionAfterContact;
}

std::vector<Foul> fouls_of(const RackState& state, bool push_out, const Facts& facts) {
    std::vector<Foul> fouls = standard_fouls(state, lowest_ball(state.on_table), facts);
    if (push_out) std::erase_if(fouls, is_waived_by_push_out);
    const bool illegal_break =
        facts.pocketed.empty() && facts.driven_to_cushion.size() < kBallsToCushionsOnBreak;
    if (state.phase == Phase::Break && illegal_break) fouls.push_back(Foul::IllegalBreak);
    std::ranges::sort(fouls);
    return fouls;
}

int fouls_in_a_row(const RackState& state, bool foul) {
    return foul ? state.consecutive_fouls[state.shooter] + 1 : 0;
}

}  // namespace

BallSet lowest_ball(BallSet on_table) {
    const std::uint32_t bits = on_table.bits();
    return BallSet::from_bits(bits & (~bits + 1));
}

bool is_push_out(const RackState& state, const model::Call& call) {
    return state.push_out_allowed && state.phase != Phase::Break &&
           std::holds_alternative<model::PushOut>(call);
}

Verdict rotation_verdict(const RackState& state, const model::Call& call, const Facts& facts,
                         model::BallId key_ball, const std::vector<Ruling>& rulings) {
    const bool push_out = is_push_out(state, call);
    std::vector<Foul> fouls = fouls_of(state, push_out, facts);
    const bool foul = !fouls.empty();
    const int in_a_row = fouls_in_a_row(state, foul);
    const Seat other = opponent_of(state.shooter);
    const std::vector<Ruling> shared{
        win_for(other, in_a_row >= kFoulsThatLose, Reason::ThreeFouls),
        {foul, Reason::Foul, other, Zone::Anywhere},
        {push_out, Reason::PushOut, other, Zone::None, {Choice::Play, Choice::PassBack}},
    };
    Verdict verdict = verdict_of(state, std::move(fouls), in_order(shared, rulings));
    const bool push_out_follows = state.phase == Phase::Break && !foul;
    verdict.phase = push_out_follows ? Phase::AfterBreak : Phase::Groups;
    verdict.consecutive_fouls[state.shooter] = in_a_row;
    const bool key_ball_down = (fallen_balls(facts) | facts.off_table).contains(key_ball);
    if (key_ball_down && !verdict.winner) verdict.spotted.push_back(key_ball);
    return verdict;
}

Verdict rotation_timeout(const RackState& state) {
    const bool before_break = state.phase == Phase::Break;
    const Zone zone = before_break ? Zone::BehindHeadString : Zone::Anywhere;
    const int in_a_row = fouls_in_a_row(state, true);
    const Seat other = opponent_of(state.shooter);
    const std::vector<Ruling> rulings{
        win_for(other, in_a_row >= kFoulsThatLose, Reason::ThreeFouls),
        {true, Reason::ClockRanOut, other, zone},
    };
    Verdict verdict = verdict_of(state, {Foul::Clock}, rulings);
    verdict.phase = before_break ? Phase::Break : Phase::Groups;
    verdict.consecutive_fouls[state.shooter] = in_a_row;
    return verdict;
}

Resolution rotation_resolution(const Verdict& verdict, Choice choice) {
    CHECK(verdict.chooser.has_value());
    Resolution resolution;
    resolution.next_player =
        choice == Choice::PassBack ? opponent_of(*verdict.chooser) : *verdict.chooser;
    resolution.in_hand = verdict.in_hand;
    return resolution;
}

}  // namespace billiards::rules
