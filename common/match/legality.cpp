// Takes a match, a seat and a command; gives done, or the first reason why not.
#include "common/match/legality.h"

#include "common/match/placement.h"
#include "common/model/table_spec.h"
#include "common/physics/simulate.h"
#include "common/rules/ruleset.h"

#include <algorithm>
#include <fmt/format.h>

namespace billiards::match {

namespace {

using Checked = Result<base::Done>;

Checked refused(RefusalCode code, std::string detail) {
    return Refusal{code, std::move(detail)};
}

std::string describe(const model::Call& call) {
    if (const auto* called = std::get_if<model::CalledBall>(&call)) {
        return fmt::format("ball {} in pocket {}", called->ball.number, called->pocket.number);
    }
    if (std::holds_alternative<model::PushOut>(call)) return "a push-out";
    return std::holds_alternative<model::Safety>(call) ? "a safety" : "no call";
}

/// What a shot's number must be and was, by the field that the engine named.
std::string explain(const std::string& field, const model::Shot& shot) {
    if (field == "power") return fmt::format("power must be in (0, 1], was {:g}", shot.power);
    if (field == "angle_rad") {
        return fmt::format("angle_rad must be within 1000 rad, was {:g}", shot.angle_rad);
    }
    if (field == "elevation_rad") {
        return fmt::format("elevation_rad must be in [0, pi/2), was {:g}", shot.elevation_rad);
    }
    if (field.starts_with("tip")) {
        return fmt::format("tip offset must be within 0.5 of the centre, was ({:g}, {:g})",
                           shot.tip_left, shot.tip_up);
    }
    return field;
}

/// One command of one seat; the match is not over.
class Legality {
  public:
    Legality(const MatchState& state, model::Seat seat) : state_(state), seat_(seat) {}

    Checked on(const PlaceCueBall& command) const {
        if (Checked turn = may_act(Stage::Shooting); !turn) return turn;
        if (state_.rack.in_hand == rules::Zone::None) {
            return refused(RefusalCode::NotInHand, "the cue ball is not in hand");
        }
        return check_placement(model::table_of(state_.settings.table), state_.layout,
                               state_.rack.in_hand, command.position_m);
    }

    Checked on(const TakeShot& command) const {
        if (Checked fresh = is_fresh(command.turn); !fresh) return fresh;
        if (Checked turn = may_act(Stage::Shooting); !turn) return turn;
        if (!state_.layout.on_table(model::kCueBall)) {
            return refused(RefusalCode::CueBallNotPlaced, "the cue ball is in hand");
        }
        const auto valid = physics::validate(command.shot);
        if (!valid) {
            return refused(RefusalCode::BadShot, explain(valid.error().detail, command.shot));
        }
        return is_callable(command.call);
    }

    Checked on(const Choose& command) const {
        if (Checked fresh = is_fresh(command.turn); !fresh) return fresh;
        if (Checked turn = may_act(Stage::Choosing); !turn) return turn;
        const std::vector<rules::Choice>& offered = state_.pending->verdict.choices;
        if (std::ranges::find(offered, command.choice) == offered.end()) {
            return refused(RefusalCode::BadChoice, "this choice was not offered");
        }
        return base::Done{};
    }

    Checked on(const Timeout& command) const {
        if (Checked fresh = is_fresh(command.turn); !fresh) return fresh;
        return may_act(state_.stage);
    }

    Checked on(const Concede&) const { return base::Done{}; }

  private:
    Checked is_fresh(model::TurnNumber turn) const {
        if (turn == state_.turn) return base::Done{};
        return refused(RefusalCode::StaleTurn, fmt::format("meant for turn {}, it is turn {}",
                                                           turn.value, state_.turn.value));
    }

    Checked may_act(Stage stage) const {
        if (seat_ != state_.to_act) {
            return refused(RefusalCode::NotYourTurn, "the other player is to act");
        }
        if (state_.stage != stage) {
            const bool choosing = state_.stage == Stage::Choosing;
            return refused(RefusalCode::WrongStage,
                           choosing ? "a choice is due first" : "no choice is due");
        }
        return base::Done{};
    }

    Checked is_callable(const model::Call& call) const {
        const rules::Ruleset& rules = rules::ruleset_of(state_.settings.game);
        if (rules.is_call_allowed(state_.rack, state_.settings.options, call)) return base::Done{};
        return refused(RefusalCode::BadCall,
                       fmt::format("{} may not be called now", describe(call)));
    }

    const MatchState& state_;
    model::Seat seat_;
};

Checked check_clock(const char* name, double clock_s) {
    // Written so that a NaN is refused.
    if (clock_s >= 0 && clock_s <= kMaxShotClock_s) return base::Done{};
    return refused(RefusalCode::BadSettings, fmt::format("{} must be in [0, {:g}], was {:g}", name,
                                                         kMaxShotClock_s, clock_s));
}

}  // namespace

Checked check(const MatchState& state, model::Seat seat, const Command& command) {
    if (state.stage == Stage::Over) return refused(RefusalCode::MatchOver, "the match is over");
    const Legality legality(state, seat);
    return std::visit([&](const auto& each) { return legality.on(each); }, command);
}

Checked check(const Settings& settings) {
    if (settings.race_to < 1 || settings.race_to > kMaxRaceTo) {
        return refused(RefusalCode::BadSettings, fmt::format("race_to must be in [1, {}], was {}",
                                                             kMaxRaceTo, settings.race_to));
    }
    const int target_points = settings.options.target_points;
    if (target_points < 1 || target_points > rules::kMaxTargetPoints) {
        return refused(RefusalCode::BadSettings,
                       fmt::format("target_points must be in [1, {}], was {}",
                                   rules::kMaxTargetPoints, target_points));
    }
    if (Checked clock = check_clock("shot_clock_s", settings.shot_clock_s); !clock) return clock;
    return check_clock("break_shot_clock_s", settings.break_shot_clock_s);
}

}  // namespace billiards::match
