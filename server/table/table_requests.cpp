// Takes what players ask of their match; refuses what is too much, too early or not theirs to ask,
// and applies the rest.
#include "common/base/check.h"
#include "server/table/table.h"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

namespace billiards::server {

using model::kSeats;
using model::Seat;
using protocol::RefusedCode;

namespace {

bool is_finite(const model::Shot& shot) {
    return std::isfinite(shot.angle_rad) && std::isfinite(shot.power) &&
           std::isfinite(shot.tip_left) && std::isfinite(shot.tip_up) &&
           std::isfinite(shot.elevation_rad);
}

/// In whole seconds, rounded up: so nobody is told to try a moment too early.
std::string seconds_text(base::Duration duration) {
    return std::to_string(std::chrono::ceil<std::chrono::seconds>(duration).count()) + " s";
}

protocol::JournalEntry entry_of(Seat seat, const match::Command& command, std::uint64_t shot_id,
                                match::Outcome outcome) {
    protocol::JournalEntry entry;
    entry.seat = seat;
    entry.command = command;
    entry.shot_id = shot_id;
    entry.verdict = std::move(outcome.verdict);
    if (outcome.record) entry.final_layout = outcome.record->final_layout;
    entry.record = std::move(outcome.record);
    return entry;
}

/// What ends a match at once, whether the balls roll or not.
bool is_for_any_time(const match::Command& command) {
    return std::holds_alternative<match::Concede>(command) ||
           std::holds_alternative<match::Forfeit>(command);
}

/// What ends a match, or may lead to that.
bool is_about_an_end(const match::Command& command) {
    return is_for_any_time(command) || std::holds_alternative<match::Offer>(command) ||
           std::holds_alternative<match::Answer>(command);
}

/// What could be said to practice without an end: nothing else there waits for the balls.
bool is_practised(const match::Command& command) {
    return std::holds_alternative<match::TakeShot>(command) ||
           std::holds_alternative<match::Undo>(command) ||
           std::holds_alternative<match::Repeat>(command) ||
           std::holds_alternative<match::Rerack>(command);
}

}  // namespace

void Table::request(base::Instant now, const Asker& asker, Command command) {
    if (!match_) {
        refuse(around_, asker, RefusedCode::NotInThisPhase, "no match has been started");
        return;
    }
    if (refuse_too_many(now, asker, command.command)) return;
    Request request{.asker = asker, .seats = {}, .what = std::move(command)};
    for (const Seat seat : seating_.seats_of(asker.session)) request.seats[seat] = true;
    enqueue(now, std::move(request));
}

/// Only whoever is to act spends the table's allowances, which their opponent must not.
bool Table::refuse_too_many(base::Instant now, const Asker& asker, const match::Command& command) {
    const match::MatchState& state = match_->state;
    if (seating_.session_of(state.to_act) != asker.session) return false;
    const bool places = std::holds_alternative<match::PlaceCueBall>(command) ||
                        std::holds_alternative<match::PlaceBall>(command);
    if (places && !placements_.allows(now)) {
        refuse(around_, asker, RefusedCode::TooMany, "placements of balls");
        return true;
    }
    const bool practises = state.settings.game == rules::Game::Practice && is_practised(command);
    if (practises && !practice_shots_.allows(now)) {
        refuse(around_, asker, RefusedCode::TooMany, "shots in practice");
        return true;
    }
    return false;
}

void Table::enqueue(base::Instant now, Request request) {
    if (!is_pending()) {
        run(now, request);
    } else if (queue_.size() < around_.limits.queued_commands) {
        queue_.push_back(std::move(request));
    } else {
        refuse(around_, *request.asker, RefusedCode::TooMany, "commands waiting for the disk");
    }
}

void Table::claim(base::Instant now, const Asker& asker) {
    if (!is_playing()) {
        refuse(around_, asker, RefusedCode::NotAllowed, "no match is being played");
        return;
    }
    Request request{.asker = asker, .seats = {}, .what = {match::Forfeit{}}};
    for (const Seat seat : seating_.seats_of(asker.session)) request.seats[seat] = true;
    enqueue(now, std::move(request));
}

/// Looked at when the claim's turn has come: the opponent may have come back while it waited.
bool Table::refuse_claim(base::Instant now, const Request& request) {
    if (!std::holds_alternative<match::Forfeit>(request.what.command)) return false;
    if (request.seats[Seat::First] && request.seats[Seat::Second]) {
        refuse(around_, *request.asker, RefusedCode::NotAllowed, "both seats are yours");
        return true;
    }
    const auto used_up_at = absence_.ends(acting_seat(request));
    if (used_up_at && *used_up_at <= now) return false;
    refuse(around_, *request.asker, RefusedCode::NotAllowed,
           used_up_at ? "the opponent may still come back for " + seconds_text(*used_up_at - now)
                      : "the opponent is here");
    return true;
}

void Table::run(base::Instant now, const Request& request) {
    if (answer_repeat(request) || refuse_early(request) || refuse_stale(request)) return;
    if (refuse_claim(now, request) || refuse_too_long(request)) return;
    const Seat seat = acting_seat(request);
    auto applied = match::apply(match_->state, seat, request.what.command);
    if (!applied) {
        CHECK(request.asker.has_value());  // The clock names the turn and the seat that are.
        refuse(around_, *request.asker, applied.error());
        return;
    }
    match::Step step = std::move(applied).value();
    commit(now, {.asker = request.asker,
                 .entry = entry_of(seat, request.what.command, request.what.shot_id,
                                   std::move(step.outcome)),
                 .next = std::move(step.next)});
}

/// The clock goes on: it ends turns, and in the end the match.
bool Table::refuse_too_long(const Request& request) {
    const bool is_long = match_->entries >= around_.limits.entries_per_match;
    if (!is_long || !request.asker || is_about_an_end(request.what.command)) return false;
    refuse(around_, *request.asker, RefusedCode::TooMany,
           "steps in this match: it can only be ended now");
    return true;
}

/// A shot that was played already is shown again to the one who asks, not played again.
bool Table::answer_repeat(const Request& request) {
    if (!std::holds_alternative<match::TakeShot>(request.what.command)) return false;
    for (const Seat seat : kSeats) {
        const auto& last = match_->last_shots[seat];
        if (!request.seats[seat] || !last || last->shot_id != request.what.shot_id) continue;
        around_.outbox.deliver(request.asker->session, last->frame, Delivery::Ordered);
        return true;
    }
    return false;
}

bool Table::refuse_early(const Request& request) {
    if (is_for_any_time(request.what.command) || !clock_.is_waiting()) return false;
    refuse(around_, *request.asker, RefusedCode::TooEarly, "the balls are still rolling");
    return true;
}

bool Table::refuse_stale(const Request& request) {
    if (!request.what.only_turn || *request.what.only_turn == match_->state.turn) return false;
    refuse(around_, *request.asker,
           match::Refusal{match::RefusalCode::StaleTurn,
                          "it is turn " + std::to_string(match_->state.turn.value)});
    return true;
}

/// The clock acts for the one whose turn it is, and so does who holds both seats, but for an answer
/// to an offer of that seat. A claim is told of the seat that is away.
Seat Table::acting_seat(const Request& request) const {
    const match::MatchState& state = match_->state;
    const auto held = [&](Seat seat) { return request.seats[seat]; };
    if (std::holds_alternative<match::Forfeit>(request.what.command)) {
        return held(Seat::First) ? Seat::Second : Seat::First;
    }
    if (std::holds_alternative<match::Answer>(request.what.command) && state.offer &&
        held(opponent_of(state.offer->by))) {
        return opponent_of(state.offer->by);
    }
    return !request.asker || held(state.to_act) ? state.to_act : opponent_of(state.to_act);
}

void Table::aim(base::Instant now, SessionId session, const protocol::client::Aim& aim) {
    if (!is_playing() || !clock_.is_open() || aim.turn != match_->state.turn) return;
    const Seat seat = match_->state.to_act;
    if (seating_.session_of(seat) != session || !is_finite(aim.shot)) return;
    const bool to_players = aim_to_players_.allows(now);
    const bool to_spectators = aim_to_spectators_.allows(now);
    if (!to_players && !to_spectators) return;
    const protocol::SharedFrame frame = protocol::encode(
        protocol::server::AimShown{.seat = seat, .turn = aim.turn, .shot = aim.shot});
    if (to_players) {
        seating_.for_each_player([&](SessionId to) {
            if (to != session) around_.outbox.deliver(to, frame, Delivery::LatestWins);
        });
    }
    if (to_spectators) show_spectators(now, frame, Delivery::LatestWins);
}

void Table::say(base::Instant now, const Asker& asker, const std::string& name,
                const std::string& text) {
    const bool is_player = !seating_.seats_of(asker.session).empty();
    if (!(is_player ? players_chat_ : stand_chat_).allows(now)) {
        refuse(around_, asker, RefusedCode::TooMany, "chat at this table");
        return;
    }
    const protocol::SharedFrame frame =
        protocol::encode(protocol::server::ChatSaid{.name = name, .text = text});
    seating_.for_each_player(
        [&](SessionId to) { around_.outbox.deliver(to, frame, Delivery::Ordered); });
    show_spectators(now, frame, Delivery::Sheddable);
}

}  // namespace billiards::server
