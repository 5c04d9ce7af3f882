// Takes the facts of a shot at ten-ball; gives the ruling. What it shares with nine-ball is in
// rotation.h.
#include "common/model/rack.h"
#include "common/rules/called_shot.h"
#include "common/rules/games.h"
#include "common/rules/racking.h"
#include "common/rules/rotation.h"

namespace billiards::rules {

namespace {

using model::BallId;
using model::BallSet;

constexpr BallId kTenBall{10};

std::vector<Ruling> break_rulings(const RackState& state, const Facts& facts) {
    return {
        {!facts.pocketed.empty(), Reason::BreakPot, state.shooter},
        {true, Reason::LegalBreak, opponent_of(state.shooter)},
    };
}

std::vector<Ruling> turn_rulings(const RackState& state, const Options& options,
                                 const model::Call& call, const Facts& facts) {
    const model::Seat shooter = state.shooter;
    const model::Seat other = opponent_of(shooter);
    const std::optional<BallId> made = called_ball_down(state.on_table, call, facts);
    const bool ten = made == kTenBall;
    const bool ten_may_win = options.ten_wins_any_time || state.on_table == BallSet{kTenBall};
    const bool pot = !facts.pocketed.empty();
    const bool safety = std::holds_alternative<model::Safety>(call);
    const std::vector<Choice> who_plays{Choice::Play, Choice::PassBack};
    return {
        win_for(shooter, ten && ten_may_win, Reason::TenWon),
        {ten, Reason::TenEarly, shooter},
        {made.has_value(), Reason::LegalPot, shooter},
        {pot, Reason::UncalledPot, other, Zone::None, who_plays},
        {safety, Reason::Safety, other},
        {true, Reason::NothingPotted, other},
    };
}

class TenBall final : public Ruleset {
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

/// A triangle of four rows: the 1 at the apex, the 10 in the middle, the rest at random.
model::Layout TenBall::rack(const Options&, const model::TableSpec& table, double radius_m,
                            base::Random& random) const {
    std::vector<BallId> balls = shuffled_balls(10, random);
    put_at(balls, 0, {1});
    put_at(balls, model::kMiddlePlace, kTenBall);
    return racked_layout(balls, model::triangle_positions(table, radius_m, 4));
}

model::BallSet TenBall::legal_first_balls(const RackState& state) const {
    return lowest_ball(state.on_table);
}

bool TenBall::is_call_allowed(const RackState& state, const Options&,
                              const model::Call& call) const {
    if (std::holds_alternative<model::NoCall>(call) || is_push_out(state, call)) return true;
    return state.phase != Phase::Break && is_shot_call(state.on_table, call);
}

Verdict TenBall::judge(const RackState& state, const Options& options, const model::Call& call,
                       const Facts& facts) const {
    const bool breaking = state.phase == Phase::Break;
    return rotation_verdict(
        state, call, facts, kTenBall,
        breaking ? break_rulings(state, facts) : turn_rulings(state, options, call, facts));
}

Verdict TenBall::judge_timeout(const RackState& state) const {
    return rotation_timeout(state);
}

Resolution TenBall::resolve(const RackState&, const Verdict& verdict, Choice choice) const {
    return rotation_resolution(verdict, choice);
}

}  // namespace

const Ruleset& ten_ball() {
    static const TenBall rules;
    return rules;
}

}  // namespace billiards::rules
