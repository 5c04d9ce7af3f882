// Takes commands for one match; gives journal entries to the disk and, when it answers, what they
// led to.
#include "common/base/check.h"
#include "common/match/clock.h"
#include "common/replay/engine_version.h"
#include "server/table/table.h"

#include <array>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace billiards::server {

using model::kSeats;
using model::Seat;
using protocol::RefusedCode;

namespace {

std::uint64_t new_seed(const RandomBytes& random) {
    std::array<std::uint8_t, sizeof(std::uint64_t)> bytes{};
    random(bytes);
    std::uint64_t seed = 0;
    std::memcpy(&seed, bytes.data(), sizeof seed);
    return seed;
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

}  // namespace

void Table::request(base::Instant now, const Asker& asker, Command command) {
    if (!match_) {
        refuse(around_, asker, RefusedCode::NotInThisPhase, "no match has been started");
        return;
    }
    // Only whoever is to act spends the table's allowance, which their opponent must not.
    if (std::holds_alternative<match::PlaceCueBall>(command.command) &&
        seating_.session_of(match_->state.to_act) == asker.session && !placements_.allows(now)) {
        refuse(around_, asker, RefusedCode::TooMany, "placements of the cue ball");
        return;
    }
    Request request{.asker = asker, .seats = {}, .what = std::move(command)};
    for (const Seat seat : seating_.seats_of(asker.session)) request.seats[seat] = true;
    if (!is_pending()) {
        run(now, request);
    } else if (queue_.size() < around_.limits.queued_commands) {
        queue_.push_back(std::move(request));
    } else {
        refuse(around_, asker, RefusedCode::TooMany, "commands waiting for the disk");
    }
}

void Table::run(base::Instant now, const Request& request) {
    if (answer_repeat(request) || refuse_early(request) || refuse_stale(request)) return;
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
    const bool any_time = std::holds_alternative<match::Concede>(request.what.command);
    if (any_time || !clock_.is_waiting()) return false;
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

/// Who holds both seats acts for the one whose turn it is; the clock does so always.
Seat Table::acting_seat(const Request& request) const {
    const Seat to_act = match_->state.to_act;
    if (!request.asker || request.seats[to_act]) return to_act;
    return opponent_of(to_act);
}

void Table::commit(base::Instant now, Step step) {
    protocol::EncodedEntry entry = protocol::encode_entry(step.entry);
    if (entry.record.size() > around_.limits.record_bytes ||
        (step.entry.record && !protocol::is_sendable(*step.entry.record))) {
        CHECK(step.asker.has_value());  // The clock takes no shots.
        refuse(around_, *step.asker,
               match::Refusal{match::RefusalCode::Unsolvable, "too much happens in this shot"});
        return;
    }
    std::vector<Write> writes;
    writes.push_back(
        AppendEntry{match_->id, {.sequence = match_->entries + 1, .entry = std::move(entry)}});
    if (step.next.stage == match::Stage::Over) writes.push_back(FinishMatch{match_->id});
    submit(now, std::move(step), std::move(writes));
}

void Table::start_match(base::Instant now) {
    const std::uint64_t seed = new_seed(around_.random);
    auto state = match::start(settings_, seed);
    CHECK(state.ok());  // The settings were tried when the table was opened.
    const MatchId id{++around_.last_match};
    StoredMatch stored{.match = id,
                       .table = id_,
                       .table_name = name_,
                       .players = {},
                       .settings = protocol::encode_settings(settings_, seed),
                       .engine = std::string(replay::kEngineVersion)};
    for (const Seat seat : kSeats) stored.players[seat] = seating_[seat]->player;
    submit(now, Start{.match = {.id = id, .state = std::move(state).value()}},
           {SaveMatch{std::move(stored)}});
}

void Table::submit(base::Instant now, Pending pending, std::vector<Write> writes) {
    pending_ = std::move(pending);
    submitted_ = now;
    around_.committer.submit(std::move(writes),
                             [this](const Committed& committed) { settle(committed); });
}

void Table::settle(const Committed& committed) {
    const base::Instant now = submitted_ + committed.took;
    const bool durable = committed.result.ok();
    around_.stats.storage_failing = !durable;
    Pending pending = std::exchange(pending_, std::monostate{});
    if (auto* start = std::get_if<Start>(&pending)) {
        durable ? happen(now, std::move(*start)) : undo_start();
    } else {
        auto& step = std::get<Step>(pending);
        durable ? happen(now, std::move(step), committed) : undo_step(now, step);
    }
    while (!is_pending() && !queue_.empty()) {
        const Request next = std::move(queue_.front());
        queue_.pop_front();
        run(now, next);
    }
    around_.moved(id_);
}

void Table::happen(base::Instant now, Start start) {
    match_ = std::move(start.match);
    rolling_.reset();
    clock_.open(now, time_allowed());
    seating_.clear_ready();
    announce_seats();
    announce_start();
}

void Table::happen(base::Instant now, Step step, const Committed& committed) {
    match_->state = step.next;
    ++match_->entries;
    const match::Command command = step.entry.command;
    if (std::holds_alternative<match::PlaceCueBall>(command)) {
        announce_placement(step);  // The turn and its clock go on.
    } else if (std::holds_alternative<match::TakeShot>(command)) {
        ++around_.stats.shots;
        clock_.wait_until(now + base::duration_of(step.entry.record->duration_s), time_allowed());
        announce_shot(now, std::move(step), committed);
    } else {
        clock_.open(now, time_allowed());
        announce_move(std::move(step));
    }
    if (is_playing()) return;
    clock_.stop();
    announce_over(std::holds_alternative<match::Concede>(command)
                      ? protocol::server::Ending::Conceded
                      : protocol::server::Ending::Played);
}

void Table::undo_start() {
    seating_.clear_ready();
    announce_storage_failed({});
    announce_seats();
}

/// The state never left the last committed one. The clock is given back: nobody loses a turn to
/// our disk, and a timeout that failed is not tried again at once.
void Table::undo_step(base::Instant now, const Step& step) {
    announce_storage_failed(step.asker);
    if (!clock_.is_open()) return;
    clock_.open(now, time_allowed());
    announce_turn();
}

void Table::restore(base::Instant now, const StoredMatch& stored, const Refolded& refolded,
                    const model::PerSeat<std::string>& names) {
    match_ = Match{.id = stored.match, .state = refolded.state, .entries = refolded.entries};
    sequence_ = refolded.entries;  // Above that of every shot which may be shown again.
    clock_.open(now, time_allowed());
    for (const Seat seat : kSeats) {
        seating_.reserve(seat, stored.players[seat], names[seat]);
        if (!refolded.last_shots[seat]) continue;
        protocol::server::ShotPlayed played = *refolded.last_shots[seat];
        played.struck_us = wire_time(now - base::duration_of(played.record.duration_s));
        played.turn = clock_.view();
        match_->last_shots[seat] = {played.shot_id, protocol::encode(played)};
    }
}

std::optional<base::Duration> Table::time_allowed() const {
    const std::optional<double> allowed_s = match::allowance_s(match_->state);
    return allowed_s ? std::optional(base::duration_of(*allowed_s)) : std::nullopt;
}

}  // namespace billiards::server
