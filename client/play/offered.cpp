// Takes a table; asks the match's own rules about every command.
#include "client/play/offered.h"

#include "common/match/legality.h"
#include "common/rules/ruleset.h"

namespace billiards::client {

namespace {

using model::Seat;

bool is_over(const TableView& table) {
    return !table.match || table.match->stage == match::Stage::Over;
}

void add_between_matches(Offered& offered, const TableView& table) {
    const bool is_rematch = is_between_the_same(table) && !has_both_seats(table);
    offered.rematch = is_rematch;
    offered.start = !is_rematch;
}

/// What the one who is to act may do.
void add_of_turn(Offered& offered, const match::MatchState& match, Seat seat) {
    const auto may = [&](const match::Command& command) {
        return match::check(match, seat, command).ok();
    };
    const auto may_say = [&](const model::Call& call) {
        return rules::ruleset_of(match.settings.game)
            .is_call_allowed(match.rack, match.settings.options, call);
    };
    offered.extension = may(match::Extend{match.turn});
    offered.spot_nearest = may(match::SpotNearest{match.turn});
    offered.claim_stalemate = may(match::ClaimStalemate{match.turn});
    offered.shoot = match.stage == match::Stage::Shooting;
    offered.safety = offered.shoot && may_say(model::Safety{});
    offered.push_out = offered.shoot && may_say(model::PushOut{});
    offered.practise = may(match::Rerack{});
    // A client is not told what lies behind an undo; only that a shot was played.
    offered.repeat = offered.practise && match.shots_played > 0;
}

/// What a player may do at any time; two at one screen agree without words.
void add_of_seat(Offered& offered, const match::MatchState& match, Seat seat) {
    const auto may = [&](const match::Command& command) {
        return match::check(match, seat, command).ok();
    };
    offered.offer_draw = may(match::Offer{match.turn, match::OfferKind::Draw});
    offered.offer_replay = may(match::Offer{match.turn, match::OfferKind::Stalemate});
    if (may(match::Answer{match.turn, true})) offered.answer = match.offer->kind;
}

}  // namespace

Offered offered(const ClientState& known, const TableView& shown, const std::optional<Seat>& acting,
                base::Instant now) {
    Offered offered;
    if (shown.my_seats.empty()) return offered;
    if (is_over(shown)) {
        add_between_matches(offered, shown);
        return offered;
    }
    const match::MatchState& match = *shown.match;
    offered.concede = true;
    if (acting) add_of_turn(offered, match, *acting);
    if (has_both_seats(shown)) return offered;
    const Seat mine = shown.my_seats.front();
    add_of_seat(offered, match, mine);
    const auto& claimable_us = shown.row.seats[model::opponent_of(mine)].claimable_us;
    const auto from = claimable_us ? local_time_of(known, *claimable_us) : std::nullopt;
    offered.claim_match = from && *from <= now;
    return offered;
}

bool has_both_seats(const TableView& table) {
    const auto& seats = table.row.seats;
    return table.my_seats.size() == 2 ||
           (seats[Seat::First].taken && seats[Seat::First].name == seats[Seat::Second].name);
}

bool is_between_the_same(const TableView& table) {
    if (!table.over || !table.players_of_match) return false;
    const auto& seats = table.row.seats;
    for (const Seat seat : {Seat::First, Seat::Second}) {
        if (!seats[seat].taken || seats[seat].name != (*table.players_of_match)[seat]) return false;
    }
    return true;
}

bool is_owner(const ClientState& known, const TableView& table) {
    return !known.name.empty() && table.row.owner == known.name;
}

}  // namespace billiards::client
