// Takes a match, a seat and a command; gives done, or the first reason why not.
#include "common/match/legality.h"

#include "common/match/clock.h"
#include "common/match/placement.h"
#include "common/model/table_spec.h"
#include "common/physics/validate.h"
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
        return fmt::format("angle_rad must be within {:g} rad, was {:g}", physics::kMostAngle_rad,
                           shot.angle_rad);
    }
    if (field == "elevation_rad") {
        return fmt::format("elevation_rad must be in [0, pi/2), was {:g}", shot.elevation_rad);
    }
    if (field.starts_with("tip")) {
        return fmt::format("tip offset must be within {:g} of the centre, was ({:g}, {:g})",
                           physics::kMostOffset, shot.tip_left, shot.tip_up);
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
        if (Checked two = is_match_of_two(); !two) return two;
        return may_act(state_.stage);
    }

    Checked on(const Concede&) const { return base::Done{}; }
    Checked on(const Forfeit&) const { return is_match_of_two(); }

    Checked on(const Extend& command) const {
        if (Checked fresh = is_fresh(command.turn); !fresh) return fresh;
        if (Checked turn = may_act(state_.stage); !turn) return turn;
        if (!allowance_s(state_)) return refused(RefusalCode::NoExtension, "no clock runs");
        if (state_.settings.extension_s <= 0.0) {
            return refused(RefusalCode::NoExtension, "this match is played without extensions");
        }
        if (state_.extended_in[seat_] != model::TurnNumber{}) {
            return refused(RefusalCode::NoExtension, "this rack's extension has been used");
        }
        return base::Done{};
    }

    Checked on(const Offer& command) const {
        if (Checked fresh = is_fresh(command.turn); !fresh) return fresh;
        if (Checked two = is_match_of_two(); !two) return two;
        if (state_.offer) return refused(RefusalCode::BadOffer, "another offer stands");
        if (command.kind == OfferKind::Stalemate && is_unbroken()) {
            return refused(RefusalCode::BadOffer, "the rack has not been broken");
        }
        return base::Done{};
    }

    Checked on(const Answer& command) const {
        if (Checked fresh = is_fresh(command.turn); !fresh) return fresh;
        if (state_.offer && state_.offer->by != seat_) return base::Done{};
        return refused(RefusalCode::NoOffer, "there is no offer to answer");
    }

    Checked on(const ClaimStalemate& command) const {
        if (Checked fresh = is_fresh(command.turn); !fresh) return fresh;
        if (Checked two = is_match_of_two(); !two) return two;
        if (Checked turn = may_act(Stage::Shooting); !turn) return turn;
        if (state_.claim) return refused(RefusalCode::BadClaim, "a stalemate is claimed already");
        if (is_unbroken()) return refused(RefusalCode::BadClaim, "the rack has not been broken");
        return base::Done{};
    }

    Checked on(const SpotNearest& command) const {
        if (Checked fresh = is_fresh(command.turn); !fresh) return fresh;
        if (Checked turn = may_act(Stage::Shooting); !turn) return turn;
        if (state_.rack.in_hand != rules::Zone::BehindHeadString) {
            return refused(RefusalCode::NotSpottable,
                           "the cue ball is not in hand behind the head string");
        }
        const rules::Ruleset& rules = rules::ruleset_of(state_.settings.game);
        const model::BallSet legal = rules.legal_first_balls(state_.rack);
        if (legal.empty() || !(legal - state_.rack.behind_head_string).empty()) {
            return refused(RefusalCode::NotSpottable, "a legal ball lies before the head string");
        }
        return base::Done{};
    }

    Checked on(const PlaceBall& command) const {
        if (Checked practice = may_practise(); !practice) return practice;
        if (state_.layout.find(command.ball) == nullptr) {
            return refused(RefusalCode::BadPlacement,
                           fmt::format("there is no ball {}", command.ball.number));
        }
        return check_placement(model::table_of(state_.settings.table), state_.layout,
                               rules::Zone::Anywhere, command.position_m, command.ball);
    }

    Checked on(const Undo&) const {
        if (Checked practice = may_practise(); !practice) return practice;
        if (!state_.undo.empty()) return base::Done{};
        return refused(RefusalCode::NothingToUndo, "there is nothing to undo");
    }

    Checked on(const Repeat&) const {
        if (Checked practice = may_practise(); !practice) return practice;
        if (state_.before_shot) return base::Done{};
        return refused(RefusalCode::NothingToUndo, "no shot has been played");
    }

    Checked on(const Rerack&) const { return may_practise(); }

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

    bool is_practice() const { return state_.settings.game == rules::Game::Practice; }
    bool is_unbroken() const { return state_.rack.phase == rules::Phase::Break; }

    Checked is_match_of_two() const {
        if (!is_practice()) return base::Done{};
        return refused(RefusalCode::WrongGame, "there is neither an opponent nor a clock");
    }

    Checked may_practise() const {
        if (!is_practice()) return refused(RefusalCode::WrongGame, "only in practice");
        return may_act(Stage::Shooting);
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

}  // namespace

Checked check(const MatchState& state, model::Seat seat, const Command& command) {
    if (state.stage == Stage::Over) return refused(RefusalCode::MatchOver, "the match is over");
    const Legality legality(state, seat);
    return std::visit([&](const auto& each) { return legality.on(each); }, command);
}

}  // namespace billiards::match
