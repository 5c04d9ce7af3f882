// Takes what moves one match on; gives journal entries to the disk and, when it answers, what they
// led to.
#include "common/base/check.h"
#include "common/match/clock.h"
#include "common/protocol/moves.h"
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
using protocol::server::Ending;

namespace {

std::uint64_t new_seed(const RandomBytes& random) {
    std::array<std::uint8_t, sizeof(std::uint64_t)> bytes{};
    random(bytes);
    std::uint64_t seed = 0;
    std::memcpy(&seed, bytes.data(), sizeof seed);
    return seed;
}

void store_answered(Surroundings& around, const Committed& committed) {
    around.stats.storage_failing = !committed.result.ok();
}

}  // namespace

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
    if (step.next.stage == match::Stage::Over) {
        writes.emplace_back(
            FinishMatch{match_->id, result_of(step.next, protocol::ending_of(step.entry.command))});
    }
    submit(now, std::move(step), std::move(writes));
}

MatchResult Table::result_of(const match::MatchState& state, Ending ending) const {
    return {.ending = ending,
            .winner = state.winner,
            .racks_won = state.racks_won,
            .shots = static_cast<std::uint32_t>(state.shots_played),
            .game = state.settings.game,
            .is_private = access_.is_private(),
            .hidden_for = base::duration_of(state.settings.spectator_delay_s)};
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
    Start start{.match = {.id = id,
                          .players = stored.players,
                          .state = std::move(state).value(),
                          .was_private = access_.is_private()}};
    saved_ = this->stored();
    std::vector<Write> writes;
    writes.emplace_back(SaveTable{*saved_});
    writes.emplace_back(SaveMatch{std::move(stored)});
    submit(now, std::move(start), std::move(writes));
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
    store_answered(around_, committed);
    Pending pending = std::exchange(pending_, std::monostate{});
    if (auto* start = std::get_if<Start>(&pending)) {
        durable ? happen(now, std::move(*start)) : undo_start(now);
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
    for (const Seat seat : kSeats) absence_.give_back(now, seat);
    count_absence(now);
    announce_seats(now);
    announce_start(now);
}

void Table::happen(base::Instant now, Step step, const Committed& committed) {
    const model::TurnNumber before = std::exchange(match_->state, step.next).turn;
    const Ending ending = protocol::ending_of(step.entry.command);
    ++match_->entries;
    if (std::holds_alternative<match::TakeShot>(step.entry.command)) {
        ++around_.stats.shots;
        clock_.wait_until(now + base::duration_of(step.entry.record->duration_s), time_allowed());
        announce_shot(now, std::move(step), committed);
    } else {
        go_on(now, step, before);
        announce_move(now, std::move(step));
    }
    if (is_playing()) return;
    clock_.stop();
    for (const Seat seat : kSeats) absence_.give_back(now, seat);
    count_absence(now);
    announce_over(now, ending);
}

/// Only what begins a turn opens its clock: whatever else is done in a turn, an offer of the
/// opponent too, leaves the time that is left.
void Table::go_on(base::Instant now, const Step& step, model::TurnNumber before) {
    if (step.next.turn != before) {
        clock_.open(now, time_allowed());
    } else if (std::holds_alternative<match::Extend>(step.entry.command)) {
        clock_.extend(base::duration_of(step.next.settings.extension_s));
    }
}

void Table::undo_start(base::Instant now) {
    seating_.clear_ready();
    around_.unsaved.insert(id_);
    count_absence(now);
    announce_storage_failed(now, {});
    announce_seats(now);
}

/// The state never left the last committed one. The clock is given back: nobody loses a turn to
/// our disk, and a timeout that failed is not tried again at once.
void Table::undo_step(base::Instant now, const Step& step) {
    announce_storage_failed(now, step.asker);
    if (!clock_.is_open()) return;
    clock_.open(now, time_allowed());
    announce_turn(now);
}

void Table::save() {
    StoredTable table = stored();
    if (table == saved_) return;
    saved_ = table;
    std::vector<Write> writes;
    writes.emplace_back(SaveTable{std::move(table)});
    const auto answered = [&around = around_, id = id_](const Committed& committed) {
        store_answered(around, committed);
        if (!committed.result) around.unsaved.insert(id);
    };
    around_.committer.submit(std::move(writes), answered);
}

void Table::save_again() {
    saved_.reset();
    save();
}

void Table::close() {
    CHECK(!is_pending());
    announce_closing();
    std::vector<Write> writes;
    if (is_playing()) {
        writes.emplace_back(FinishMatch{match_->id, result_of(match_->state, Ending::Abandoned)});
    }
    writes.emplace_back(RemoveTable{id_});
    submit_and_forget(std::move(writes));
}

/// The table may be gone when the answer comes.
void Table::submit_and_forget(std::vector<Write> writes) {
    around_.committer.submit(std::move(writes), [&around = around_](const Committed& committed) {
        store_answered(around, committed);
    });
}

void Table::restore(base::Instant now, const Sitters& sitters,
                    const std::optional<Played>& played) {
    for (const Seat seat : kSeats) {
        if (sitters[seat]) seating_.reserve(seat, sitters[seat]->player, sitters[seat]->name);
    }
    if (played) restore_match(now, *played);
    count_absence(now);
    if (gallery_.is_delayed()) restore_gallery(now);
    saved_ = stored();
}

void Table::restore_match(base::Instant now, const Played& played) {
    const Refolded& refolded = played.refolded;
    match_ =
        Match{.id = played.match.match,
              .players = played.match.players,
              .state = refolded.state,
              .entries = refolded.entries,
              .was_private = access_.is_private() || refolded.state.stage == match::Stage::Over};
    sequence_ = refolded.entries;  // Above that of every shot which may be shown again.
    log_.skip_to(sequence_);
    if (is_playing()) clock_.open(now, time_allowed());
    for (const Seat seat : kSeats) {
        if (!refolded.last_shots[seat]) continue;
        protocol::server::ShotPlayed shot = *refolded.last_shots[seat];
        shot.struck_us = wire_time(now - base::duration_of(shot.record.duration_s));
        shot.turn = clock_.view();
        match_->last_shots[seat] = {shot.shot_id, protocol::encode(shot)};
    }
}

/// What was shown before is forgotten. So who sits here and whether they play is shown at once, for
/// free seats would invite whoever is then refused; and all else when it may be.
void Table::restore_gallery(base::Instant now) {
    Picture seats;
    seats.row = row_now();
    seats.row.racks_won = {};
    gallery_.begin_with(std::move(seats));
    gallery_.jump(now, picture());
}

std::optional<base::Duration> Table::time_allowed() const {
    const std::optional<double> allowed_s = match::allowance_s(match_->state);
    return allowed_s ? std::optional(base::duration_of(*allowed_s)) : std::nullopt;
}

}  // namespace billiards::server
