// Takes a match, a legal command and its consequence; gives the next match.
#include "common/match/advance.h"

#include "common/base/check.h"
#include "common/match/placement.h"
#include "common/match/practice.h"
#include "common/match/racks.h"
#include "common/model/table_spec.h"
#include "common/rules/ruleset.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace billiards::match {

namespace {

using model::Seat;
using rules::Phase;
using rules::Zone;

const model::TableSpec& table_of(const MatchState& match) {
    return model::table_of(match.settings.table);
}

model::BallSet legal_balls(const MatchState& match) {
    return rules::ruleset_of(match.settings.game).legal_first_balls(match.rack);
}

void take_cue_ball_in_hand(model::Layout& layout) {
    model::PlacedBall* cue_ball = layout.find(model::kCueBall);
    CHECK(cue_ball != nullptr);
    cue_ball->place = model::Place::InHand;
    cue_ball->position_m = {};
}

void give_table_to(MatchState& match, Seat player, Zone in_hand,
                   std::span<const model::BallId> spotted) {
    match.to_act = player;
    match.rack.shooter = player;
    match.rack.in_hand = in_hand;
    match.stage = Stage::Shooting;
    match.pending.reset();
    if (in_hand != Zone::None) take_cue_ball_in_hand(match.layout);
    spot_balls(table_of(match), match.layout, spotted);
    count_balls(match);
}

void follow(MatchState& match, const rules::Verdict& verdict) {
    const rules::RackState before = match.rack;
    match.rack.phase = verdict.phase;
    match.rack.push_out_allowed = verdict.phase == Phase::AfterBreak;
    match.rack.groups = verdict.groups;
    match.rack.consecutive_fouls = verdict.consecutive_fouls;
    for (const Seat seat : model::kSeats) match.rack.scores[seat] += verdict.score_change[seat];
    if (verdict.winner) {
        match.rack.in_hand = Zone::None;
        return end_rack(match, *verdict.winner);
    }
    if (verdict.phase == Phase::Break) match.breaker = verdict.next_player;
    give_table_to(match, verdict.next_player, verdict.in_hand, verdict.spotted);
    rack_on(match, verdict.rerack);
    if (verdict.choices.empty()) return;
    match.stage = Stage::Choosing;
    match.pending = MatchState::Pending{verdict, before};
}

void choose(MatchState& match, rules::Choice choice) {
    CHECK(match.pending.has_value());
    const rules::Ruleset& rules = rules::ruleset_of(match.settings.game);
    const rules::Resolution resolution =
        rules.resolve(match.pending->before, match.pending->verdict, choice);
    if (resolution.rerack) return rack_again(match, resolution.next_player);
    std::vector<model::BallId> spotted = resolution.spotted;
    std::erase_if(spotted, [&](model::BallId ball) { return match.layout.on_table(ball); });
    give_table_to(match, resolution.next_player, resolution.in_hand, spotted);
}

/// Whatever stood for this turn alone is gone with it.
void end_turn(MatchState& match) {
    ++match.turn.value;
    match.offer.reset();
}

/// By agreement or as claimed: the same rack and breaker, nobody's fouls.
void play_again(MatchState& match) {
    rack_again(match, match.breaker);
    match.rack.consecutive_fouls = {};
}

bool is_quiet(const MatchState& match, const Consequence& shot) {
    const auto is_down = [&](const model::PlacedBall& placed) {
        return match.rack.on_table.contains(placed.ball) && placed.place != model::Place::OnTable;
    };
    return shot.verdict->fouls.empty() && std::ranges::none_of(shot.final_layout->balls, is_down);
}

/// After a shot that did not end the rack.
void count_claimed_turn(MatchState& match, Seat shooter, bool was_quiet) {
    if (!match.claim) return;
    if (!was_quiet) return match.claim.reset();
    ++(*match.claim)[shooter];
    const bool is_stalemate =
        std::ranges::all_of(match.claim->values, [](int turns) { return turns >= kTurnsOfClaim; });
    if (is_stalemate) play_again(match);
}

/// What each command does to a match.
class Fold {
  public:
    Fold(MatchState& match, Seat seat, const Consequence& consequence)
        : match_(match), seat_(seat), consequence_(consequence) {}

    void on(const PlaceCueBall& command) {
        model::PlacedBall* cue_ball = match_.layout.find(model::kCueBall);
        CHECK(cue_ball != nullptr);
        cue_ball->place = model::Place::OnTable;
        cue_ball->position_m = command.position_m;
    }
    void on(const TakeShot&) {
        CHECK(consequence_.final_layout != nullptr && consequence_.verdict != nullptr);
        if (is_practice()) {
            match_.before_shot = MatchState::Position{match_.rack, match_.layout};
            remember(match_);
        }
        end_turn(match_);
        ++match_.shots_played;
        const bool was_quiet = is_quiet(match_, consequence_);
        match_.layout = *consequence_.final_layout;
        follow(match_, *consequence_.verdict);
        count_claimed_turn(match_, seat_, was_quiet);
    }
    void on(const Choose& command) {
        end_turn(match_);
        choose(match_, command.choice);
    }
    void on(const Timeout&) {
        end_turn(match_);
        if (match_.stage == Stage::Choosing) {
            return choose(match_, match_.pending->verdict.choices.front());
        }
        CHECK(consequence_.verdict != nullptr);
        match_.claim.reset();
        follow(match_, *consequence_.verdict);
    }
    void on(const Concede&) {
        end_turn(match_);
        end_match(match_, is_practice() ? std::nullopt : std::optional(opponent_of(seat_)));
    }
    void on(const Forfeit&) {
        end_turn(match_);
        end_match(match_, opponent_of(seat_));
    }
    void on(const Extend&) { match_.extended_in[seat_] = match_.turn; }
    void on(const Offer& offer) { match_.offer = MatchState::StandingOffer{offer.kind, seat_}; }
    void on(const Answer& answer) {
        const OfferKind kind = match_.offer->kind;
        match_.offer.reset();
        if (!answer.accept) return;
        end_turn(match_);
        kind == OfferKind::Draw ? end_match(match_, std::nullopt) : play_again(match_);
    }
    void on(const ClaimStalemate&) { match_.claim.emplace(); }
    void on(const SpotNearest&) {
        spot_nearest(table_of(match_), match_.layout, legal_balls(match_));
        count_balls(match_);
    }
    void on(const PlaceBall& command) { place_ball(match_, command); }
    void on(const Undo&) {
        end_turn(match_);
        undo(match_);
    }
    void on(const Repeat&) {
        end_turn(match_);
        repeat(match_);
    }
    void on(const Rerack&) {
        end_turn(match_);
        remember(match_);
        rack_up(match_, seat_);
    }

  private:
    bool is_practice() const { return match_.settings.game == rules::Game::Practice; }

    MatchState& match_;
    Seat seat_;
    const Consequence& consequence_;
};

}  // namespace

MatchState first_rack(const Settings& settings, std::uint64_t seed) {
    MatchState match;
    match.settings = settings;
    match.seed = seed;
    rack_up(match, first_breaker(match));
    return match;
}

MatchState advance(const MatchState& state, Seat seat, const Command& command,
                   const Consequence& consequence) {
    MatchState next = state;
    Fold fold(next, seat, consequence);
    std::visit([&](const auto& each) { fold.on(each); }, command);
    return next;
}

}  // namespace billiards::match
