// Takes a match; gives it with its balls racked, counted or put away.
#include "common/match/racks.h"

#include "common/base/check.h"
#include "common/base/random.h"
#include "common/match/placement.h"
#include "common/match/rerack.h"
#include "common/model/table_spec.h"
#include "common/rules/ruleset.h"

#include <cstdint>

namespace billiards::match {

namespace {

using model::Seat;

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
            const Seat first = first_breaker(match);
            return match.rack_number % 2 == 0 ? first : opponent_of(first);
        }
    }
    CHECK(false);
}

}  // namespace

void count_balls(MatchState& match) {
    match.rack.on_table = {};
    for (const model::PlacedBall& placed : match.layout.balls) {
        const bool on_table = placed.place == model::Place::OnTable;
        if (on_table && placed.ball != model::kCueBall) match.rack.on_table.insert(placed.ball);
    }
    match.rack.behind_head_string =
        balls_behind_head_string(model::table_of(match.settings.table), match.layout);
}

Seat first_breaker(const MatchState& match) {
    if (match.settings.game == rules::Game::Practice) return Seat::First;
    return model::kSeats[base::Random(match.seed).below(model::kSeats.size())];
}

void rack_up(MatchState& match, Seat breaker) {
    base::Random random = rack_random(match.seed, match.rack_number);
    const rules::Ruleset& rules = rules::ruleset_of(match.settings.game);
    match.layout = rules.rack(match.settings.options, model::table_of(match.settings.table),
                              model::BallSpec{}.radius_m, random);
    match.rack = {};
    match.rack.shooter = breaker;
    match.rack.in_hand = rules::Zone::BehindHeadString;
    match.breaker = breaker;
    match.to_act = breaker;
    match.stage = Stage::Shooting;
    match.pending.reset();
    match.claim.reset();
    count_balls(match);
}

void rack_again(MatchState& match, Seat breaker) {
    const rules::RackState before = match.rack;
    rack_up(match, breaker);
    match.rack.scores = before.scores;
    match.rack.consecutive_fouls = before.consecutive_fouls;
}

void rack_on(MatchState& match, rules::Rerack which) {
    if (which == rules::Rerack::None) return;
    const std::uint64_t turn = match.turn.value;
    base::Random random(rack_random(match.seed, match.rack_number).next() ^ turn);
    const model::TableSpec& table = model::table_of(match.settings.table);
    const rules::Zone zone = rerack(table, match.layout, which, random);
    if (zone != rules::Zone::None) match.rack.in_hand = zone;
    count_balls(match);
}

void end_rack(MatchState& match, Seat winner) {
    if (++match.racks_won[winner] >= match.settings.race_to) return end_match(match, winner);
    const Seat breaker = breaker_of_next_rack(match, winner);
    ++match.rack_number;
    match.extended_in = {};
    rack_up(match, breaker);
}

void end_match(MatchState& match, std::optional<Seat> winner) {
    match.stage = Stage::Over;
    match.winner = winner;
    match.pending.reset();
    match.claim.reset();
    match.offer.reset();
    count_balls(match);
}

}  // namespace billiards::match
