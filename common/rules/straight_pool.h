// Gives straight pool (14.1 continuous): World Standardized Rules (WPA, 2016), part 4.
#pragma once

#include "common/rules/ruleset.h"

namespace billiards::rules {

class StraightPool final : public Ruleset {
  public:
    /// A triangle of fifteen, in random order.
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

}  // namespace billiards::rules
