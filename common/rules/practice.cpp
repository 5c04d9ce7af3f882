// Takes a shot at practice; gives who is next: always the one who played.
#include "common/base/check.h"
#include "common/rules/games.h"
#include "common/rules/ruling.h"

namespace billiards::rules {

namespace {

Verdict play_on(const RackState& state, Zone in_hand) {
    const Ruling ruling[] = {{true, Reason::Practice, state.shooter, in_hand}};
    return verdict_of(state, {}, ruling);
}

class Practice final : public Ruleset {
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

/// The triangle of eight-ball.
model::Layout Practice::rack(const Options& options, const model::TableSpec& table, double radius_m,
                             base::Random& random) const {
    return ruleset_of(Game::EightBall).rack(options, table, radius_m, random);
}

model::BallSet Practice::legal_first_balls(const RackState& state) const {
    return state.on_table;
}

bool Practice::is_call_allowed(const RackState&, const Options&, const model::Call& call) const {
    return std::holds_alternative<model::NoCall>(call);
}

Verdict Practice::judge(const RackState& state, const Options&, const model::Call&,
                        const Facts& facts) const {
    Verdict verdict = play_on(state, facts.cue_ball_lost ? Zone::Anywhere : Zone::None);
    verdict.phase = Phase::Groups;
    return verdict;
}

Verdict Practice::judge_timeout(const RackState& state) const {
    return play_on(state, state.in_hand);
}

Resolution Practice::resolve(const RackState&, const Verdict&, Choice) const {
    CHECK(false);  // Nothing is ever offered.
}

}  // namespace

const Ruleset& practice() {
    static const Practice rules;
    return rules;
}

}  // namespace billiards::rules
