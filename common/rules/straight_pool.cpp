// Takes the facts of a shot at straight pool; gives the ruling: who plays, the points, and which
// balls are racked again.
#include "common/base/check.h"
#include "common/model/rack.h"
#include "common/rules/called_shot.h"
#include "common/rules/games.h"
#include "common/rules/racking.h"
#include "common/rules/ruling.h"
#include "common/rules/standard_fouls.h"

#include <utility>

namespace billiards::rules {

namespace {

using model::BallSet;
using model::Seat;

constexpr int kBallsToCushionsOnBreak = 2;
constexpr int kFoulsInARow = 3;
constexpr int kFoulPoints = -1;
constexpr int kThirdFoulPoints = kFoulPoints - 15;
constexpr int kBreakingFoulPoints = -2;

bool is_breaking_foul(const RackState& state, const model::Call& call, const Facts& facts) {
    const BallSet cue_ball{model::kCueBall};
    const BallSet driven = facts.driven_after_contact;
    const bool opened =
        driven.contains(model::kCueBall) && (driven - cue_ball).size() >= kBallsToCushionsOnBreak;
    return state.phase == Phase::Break && !opened && !called_ball_down(state.on_table, call, facts);
}

bool is_third_in_a_row(const RackState& state) {
    return state.consecutive_fouls[state.shooter] + 1 >= kFoulsInARow;
}

std::vector<Ruling> rulings_on_fouls(const RackState& state, const std::vector<Foul>& fouls,
                                     bool scratch) {
    const Seat shooter = state.shooter;
    const Seat other = opponent_of(shooter);
    const Zone behind = Zone::BehindHeadString;
    const Zone cue_ball = scratch ? behind : Zone::None;
    const bool foul = !fouls.empty();
    const bool breaking_foul = foul && fouls.back() == Foul::BreakingFoul;
    return {
        {breaking_foul,
         Reason::BreakingFoul,
         other,
         cue_ball,
         {Choice::Accept, Choice::RebreakOpponent}},
        {foul && is_third_in_a_row(state), Reason::ThreeFouls, shooter, behind},
        {foul, Reason::Foul, other, cue_ball},
    };
}

std::vector<Ruling> rulings_without_foul(const RackState& state, const Options& options,
                                         const model::Call& call, const Facts& facts) {
    const Seat shooter = state.shooter;
    const Seat other = opponent_of(shooter);
    const bool made = called_ball_down(state.on_table, call, facts).has_value();
    const int score = state.scores[shooter] + static_cast<int>(facts.pocketed.size());
    return {
        win_for(shooter, made && score >= options.target_points, Reason::TargetReached),
        {made, Reason::LegalPot, shooter},
        {std::holds_alternative<model::Safety>(call), Reason::Safety, other},
        {!facts.pocketed.empty(), Reason::NotCalled, other},
        {state.phase == Phase::Break, Reason::LegalBreak, other},
        {true, Reason::NothingPotted, other},
    };
}

/// What the ruling costs in points and adds to the fouls in a row. A breaking foul counts neither
/// way.
void charge(Verdict& verdict, Seat shooter) {
    int& points = verdict.score_change[shooter];
    int& in_a_row = verdict.consecutive_fouls[shooter];
    if (verdict.reason == Reason::BreakingFoul) {
        points = kBreakingFoulPoints;
    } else if (verdict.reason == Reason::ThreeFouls) {
        points = kThirdFoulPoints;
        in_a_row = 0;
        verdict.phase = Phase::Break;
        verdict.rerack = Rerack::Fifteen;
    } else if (!verdict.fouls.empty()) {
        points = kFoulPoints;
        ++in_a_row;
    } else {
        in_a_row = 0;
    }
}

/// Spots the balls that did not count; those that did stay down, and a new rack follows where they
/// leave one ball or none.
void bring_balls_back(Verdict& verdict, const RackState& state, const Facts& facts, bool made) {
    const BallSet down = fallen_balls(facts) | facts.off_table;
    if (!made) {
        down.for_each([&](model::BallId ball) { verdict.spotted.push_back(ball); });
        return;
    }
    const BallSet left = state.on_table - down;
    if (left.size() == 1) verdict.rerack = Rerack::Fourteen;
    if (left.empty()) verdict.rerack = Rerack::Fifteen;
}

class StraightPool final : public Ruleset {
  public:
    model::Layout rack(const Options& options, const model::TableSpec& table, double radius_m,
                       base::Random& random) const override;
    model::BallSet legal_first_balls(const RackState& state) const override;
    bool is_call_allowed(const RackState& state, const Options& options,
                         const model::Call& call) const override;
    Verdict judge(const RackState& state, const Options& options, const model::Call& call,
                  const Facts& facts) const override;
    Verdict judge_timeout(const RackState& state) const override;
    Resolution resolve(const RackState& before, const Verdict& verdict,
                       Choice choice) const override;
};

/// A triangle of fifteen, in random order.
model::Layout StraightPool::rack(const Options&, const model::TableSpec& table, double radius_m,
                                 base::Random& random) const {
    return racked_layout(shuffled_balls(15, random), model::triangle_positions(table, radius_m));
}

BallSet StraightPool::legal_first_balls(const RackState& state) const {
    return state.on_table;
}

bool StraightPool::is_call_allowed(const RackState& state, const Options&,
                                   const model::Call& call) const {
    return std::holds_alternative<model::NoCall>(call) || is_shot_call(state.on_table, call);
}

Verdict StraightPool::judge(const RackState& state, const Options& options, const model::Call& call,
                            const Facts& facts) const {
    std::vector<Foul> fouls = standard_fouls(state, state.on_table, facts);
    if (is_breaking_foul(state, call, facts)) fouls.push_back(Foul::BreakingFoul);
    const auto rulings = in_order(rulings_on_fouls(state, fouls, facts.cue_ball_lost),
                                  rulings_without_foul(state, options, call, facts));
    Verdict verdict = verdict_of(state, std::move(fouls), rulings);
    verdict.phase = Phase::Groups;
    charge(verdict, state.shooter);
    const bool made = verdict.fouls.empty() && called_ball_down(state.on_table, call, facts);
    if (made) verdict.score_change[state.shooter] = static_cast<int>(facts.pocketed.size());
    const bool goes_on = !verdict.winner && verdict.reason != Reason::ThreeFouls;
    if (goes_on) bring_balls_back(verdict, state, facts, made);
    return verdict;
}

/// A standard foul: the cue ball stays, or stays in hand.
Verdict StraightPool::judge_timeout(const RackState& state) const {
    const Ruling rulings[] = {
        {is_third_in_a_row(state), Reason::ThreeFouls, state.shooter, Zone::BehindHeadString},
        {true, Reason::ClockRanOut, opponent_of(state.shooter), state.in_hand},
    };
    Verdict verdict = verdict_of(state, {Foul::Clock}, rulings);
    charge(verdict, state.shooter);
    return verdict;
}

Resolution StraightPool::resolve(const RackState&, const Verdict& verdict, Choice choice) const {
    CHECK(verdict.chooser.has_value());
    const Seat self = *verdict.chooser;
    Resolution resolution;
    resolution.rerack = choice == Choice::RebreakOpponent;
    resolution.next_player = resolution.rerack ? opponent_of(self) : self;
    resolution.in_hand = resolution.rerack ? Zone::BehindHeadString : verdict.in_hand;
    return resolution;
}

}  // namespace

const Ruleset& straight_pool() {
    static const StraightPool rules;
    return rules;
}

}  // namespace billiards::rules
