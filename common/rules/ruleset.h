// Gives the seam between a game's rules and everything that plays it: a game is one file that
// implements Ruleset.
#pragma once

#include "common/base/random.h"
#include "common/model/ball.h"
#include "common/model/layout.h"
#include "common/model/shot.h"
#include "common/model/table_spec.h"
#include "common/rules/facts.h"
#include "common/rules/verdict.h"

#include <vector>

namespace billiards::rules {

/// Pure: no state, no clock, no positions after the shot.
class Ruleset {
  public:
    virtual ~Ruleset() = default;

    /// The racked object balls and the cue ball in hand.
    virtual model::Layout rack(const Options& options, const model::TableSpec& table,
                               double radius_m, base::Random& random) const = 0;
    /// Balls that may be hit first. Empty only at practice: elsewhere a rack with nothing to hit is
    /// over, or is set up again.
    virtual model::BallSet legal_first_balls(const RackState& state) const = 0;
    /// Whether `call` may be said before this shot.
    virtual bool is_call_allowed(const RackState& state, const Options& options,
                                 const model::Call& call) const = 0;
    virtual Verdict judge(const RackState& state, const Options& options, const model::Call& call,
                          const Facts& facts) const = 0;
    /// The ruling when the shooter's clock ran out before a shot.
    virtual Verdict judge_timeout(const RackState& state) const = 0;
    /// What follows when verdict.chooser takes `choice`, which is one of verdict.choices.
    virtual Resolution resolve(const RackState& before, const Verdict& verdict,
                               Choice choice) const = 0;
};

/// The rules of a game; valid for the whole program.
const Ruleset& ruleset_of(Game game);

}  // namespace billiards::rules
