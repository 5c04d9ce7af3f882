// Takes the facts of a shot at nine-ball; gives the ruling. What it shares with ten-ball is in
// rotation.h.
#include "common/model/rack.h"
#include "common/rules/games.h"
#include "common/rules/racking.h"
#include "common/rules/rotation.h"

namespace billiards::rules {

namespace {

constexpr model::BallId kNineBall{9};

std::vector<Ruling> rulings_without_foul(const RackState& state, const Facts& facts) {
    const model::Seat shooter = state.shooter;
    const model::Seat other = opponent_of(shooter);
    const bool breaking = state.phase == Phase::Break;
    const bool pot = !facts.pocketed.empty();
    return {
        win_for(shooter, fallen_balls(facts).contains(kNineBall), Reason::NineWon),
        {breaking && pot, Reason::BreakPot, shooter},
        {breaking, Reason::LegalBreak, other},
        {pot, Reason::LegalPot, shooter},
        {true, Reason::NothingPotted, other},
    };
}

class NineBall final : public Ruleset {
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

/// A diamond: the 1 at the apex, the 9 in the middle, the rest at random.
model::Layout NineBall::rack(const Options& options, const model::TableSpec& table, double radius_m,
                             base::Random& random) const {
    using model::OnFootSpot;
    std::vector<model::BallId> balls = shuffled_balls(9, random);
    put_at(balls, 0, {1});
    put_at(balls, model::kMiddlePlace, kNineBall);
    const OnFootSpot on_spot = options.nine_on_foot_spot ? OnFootSpot::Middle : OnFootSpot::Apex;
    return racked_layout(balls, model::diamond_positions(table, radius_m, on_spot));
}

model::BallSet NineBall::legal_first_balls(const RackState& state) const {
    return lowest_ball(state.on_table);
}

bool NineBall::is_call_allowed(const RackState& state, const Options&,
                               const model::Call& call) const {
    return std::holds_alternative<model::NoCall>(call) || is_push_out(state, call);
}

Verdict NineBall::judge(const RackState& state, const Options&, const model::Call& call,
                        const Facts& facts) const {
    return rotation_verdict(state, call, facts, kNineBall, rulings_without_foul(state, facts));
}

Verdict NineBall::judge_timeout(const RackState& state) const {
    return rotation_timeout(state);
}

Resolution NineBall::resolve(const RackState&, const Verdict& verdict, Choice choice) const {
    return rotation_resolution(verdict, choice);
}

}  // namespace

const Ruleset& nine_ball() {
    static const NineBall rules;
    return rules;
}

}  // namespace billiards::rules
