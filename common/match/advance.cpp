// Takes a match, a legal command and its consequence; gives the next match.
#include "common/match/advance.h"

#include "common/base/check.h"
#include "common/base/random.h"
#include "common/match/placement.h"
#include "common/model/table_spec.h"
#include "common/rules/ruleset.h"

#include <span>

namespace billiards::match {

namespace {

using model::Seat;
using rules::Phase;
using rules::Zone;

const model::TableSpec& table_of(const MatchState& match) {
    return model::table_of(match.settings.table);
}

Seat first_breaker(std::uint64_t seed) {
    return model::kSeats[base::Random(seed).below(model::kSeats.size())];
}

/// The same for a rack that is racked again: who breaks it changes, its order does not.
base::Random rack_random(std::uint64_t seed, int rack_number) {
    return base::Random(base::Random(seed).next() ^ static_cast<std::uint64_t>(rack_number));
}

/// Alternation counts from the first break of the match, so that a rack that was broken again by
/// the other player does not shift it.
Seat breaker_of_next_rack(const MatchState& match, Seat winner) {
    switch (match.settings.break_order) {
        case BreakOrder::Winner:
            return winner;
        case BreakOrder::Loser:
            return opponent_of(winner);
        case BreakOrder::Alternate: {
            const Seat first = first_breaker(match.seed);
            return match.rack_number % 2 == 0 ? first : opponent_of(first);
        }
    }
    CHECK(false);
}

/// What the rules know of the balls follows from where they lie.
void count_balls(MatchState& match) {
    match.rack.on_table = {};
    for (const model::PlacedBall& placed : match.layout.balls) {
        const bool on_table = placed.place == model::Place::OnTable;
        if (on_table && placed.ball != model::kCueBall) match.rack.on_table.insert(placed.ball);
    }
    match.rack.behind_head_string = balls_behind_head_string(table_of(match), match.layout);
}

void take_cue_ball_in_hand(model::Layout& layout) {
    model::PlacedBall* cue_ball = layout.find(model::kCueBall);
    CHECK(cue_ball != nullptr);
    cue_ball->place = model::Place::InHand;
    cue_ball->position_m = {};
}

void rack_up(MatchState& match, Seat breaker) {
    base::Random random = rack_random(match.seed, match.rack_number);
    const rules::Ruleset& rules = rules::ruleset_of(match.settings.game);
    match.layout =
        rules.rack(match.settings.options, table_of(match), model::BallSpec{}.radius_m, random);
    match.rack = {};
    match.rack.shooter = breaker;
    match.rack.in_hand = Zone::BehindHeadString;
    match.breaker = breaker;
    match.to_act = breaker;
    match.stage = Stage::Shooting;
    match.pending.reset();
    count_balls(match);
}

void end_match(MatchState& match, Seat winner) {
    match.stage = Stage::Over;
    match.winner = winner;
    match.pending.reset();
    count_balls(match);
}

void end_rack(MatchState& match, Seat winner) {
    if (++match.racks_won[winner] >= match.settings.race_to) return end_match(match, winner);
    const Seat breaker = breaker_of_next_rack(match, winner);
    ++match.rack_number;
    rack_up(match, breaker);
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
    if (verdict.choices.empty()) return;
    match.stage = Stage::Choosing;
    match.pending = MatchState::Pending{verdict, before};
}

void choose(MatchState& match, rules::Choice choice) {
    CHECK(match.pending.has_value());
    const rules::Ruleset& rules = rules::ruleset_of(match.settings.game);
    const rules::Resolution resolution =
        rules.resolve(match.pending->before, match.pending->verdict, choice);
    if (resolution.rerack) return rack_up(match, resolution.next_player);
    give_table_to(match, resolution.next_player, resolution.in_hand, resolution.spotted);
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
        ++match_.turn.value;
        ++match_.shots_played;
        match_.layout = *consequence_.final_layout;
        follow(match_, *consequence_.verdict);
    }
    void on(const Choose& command) {
        ++match_.turn.value;
        choose(match_, command.choice);
    }
    void on(const Timeout&) {
        ++match_.turn.value;
        if (match_.stage == Stage::Choosing) {
            return choose(match_, match_.pending->verdict.choices.front());
        }
        CHECK(consequence_.verdict != nullptr);
        follow(match_, *consequence_.verdict);
    }
    void on(const Concede&) {
        ++match_.turn.value;
        end_match(match_, opponent_of(seat_));
    }

  private:
    MatchState& match_;
    Seat seat_;
    const Consequence& consequence_;
};

}  // namespace

MatchState first_rack(const Settings& settings, std::uint64_t seed) {
    MatchState match;
    match.settings = settings;
    match.seed = seed;
    rack_up(match, first_breaker(seed));
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
