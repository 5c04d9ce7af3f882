// Takes what happened at a table; gives each frame, encoded once, to everyone who is there.
#include "common/base/check.h"
#include "common/match/practice.h"
#include "common/protocol/codec.h"
#include "common/protocol/moves.h"
#include "server/table/table.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>
#include <variant>

namespace billiards::server {
namespace {

namespace say = protocol::server;

std::uint32_t wire_duration_us(base::Duration duration) {
    constexpr auto kMost = std::chrono::microseconds(std::numeric_limits<std::uint32_t>::max());
    return static_cast<std::uint32_t>(
        std::clamp(duration, base::Duration::zero(), base::Duration(kMost)).count());
}

}  // namespace

template <class Event>
protocol::SharedFrame Table::numbered(Event event) {
    event.sequence = ++sequence_;
    return protocol::encode(std::move(event));
}

/// The one way of everything that has a number.
void Table::publish(base::Instant now, const protocol::SharedFrame& frame,
                    std::optional<SessionId> except) {
    log_.append(frame);
    CHECK(log_.last() == sequence_);
    seating_.for_each_player([&](SessionId to) {
        if (to != except) around_.outbox.deliver(to, frame, Delivery::Ordered);
    });
    if (gallery_.is_delayed()) {
        gallery_.add(now, frame, picture());
    } else {
        deliver_to_spectators(frame, Delivery::Sheddable);
    }
}

void Table::show_spectators(base::Instant now, const protocol::SharedFrame& frame,
                            Delivery delivery) {
    if (gallery_.is_delayed()) {
        gallery_.add(now, frame, delivery);
    } else {
        deliver_to_spectators(frame, delivery);
    }
}

void Table::deliver_to_spectators(const protocol::SharedFrame& frame, Delivery delivery) {
    seating_.for_each_spectator([&](SessionId to) { around_.outbox.deliver(to, frame, delivery); });
}

void Table::show_what_is_due(base::Instant now) {
    if (!gallery_.is_delayed()) return;
    for (const Gallery::News& news : gallery_.take_due(now)) {
        deliver_to_spectators(news.frame, news.delivery);
    }
    if (gallery_.is_delayed()) return;
    seating_.for_each_spectator([&](SessionId to) { send_snapshot(now, to); });
}

bool Table::is_shown_late(SessionId session) const {
    return gallery_.is_delayed() && seating_.seats_of(session).empty();
}

Picture Table::picture() const {
    Picture picture{.sequence = sequence_,
                    .row = row_now(),
                    .match_id = {},
                    .steps = 0,
                    .match_was_private = match_ && match_->was_private,
                    .match = {},
                    .rolling = {},
                    .turn = clock_.view()};
    if (match_) {
        picture.match_id = match_->id;
        picture.steps = match_->entries + 1;
        picture.match = match::as_told(match_->state);
    }
    if (rolling_) {
        picture.rolling = rolling_->frame;
        picture.rests = rolling_->rests;
    }
    return picture;
}

void Table::send_snapshot(base::Instant now, SessionId to) {
    const bool late = is_shown_late(to);
    say::TableSnapshot snapshot = late ? gallery_.snapshot(now) : snapshot_of(picture(), now);
    snapshot.stream = late ? gallery_.stream() : stream_;
    snapshot.your_seats = seating_.seats_of(to);
    const Delivery delivery = snapshot.your_seats.empty() ? Delivery::Fresh : Delivery::Ordered;
    around_.outbox.deliver(to, protocol::encode(std::move(snapshot)), delivery);
}

void Table::catch_up(base::Instant now, SessionId to,
                     const std::optional<protocol::client::Followed>& followed) {
    const bool late = is_shown_late(to);
    const std::uint64_t stream = late ? gallery_.stream() : stream_;
    const EventLog& log = late ? gallery_.log() : log_;
    const bool is_known = followed && followed->table == id_ && followed->stream == stream;
    const auto missed = is_known ? log.since(followed->sequence) : std::nullopt;
    if (!missed) return send_snapshot(now, to);
    const std::vector<model::Seat> seats = seating_.seats_of(to);
    const Delivery delivery = seats.empty() ? Delivery::Sheddable : Delivery::Ordered;
    around_.outbox.deliver(
        to,
        protocol::encode(
            say::Resumed{.table = id_, .your_seats = seats, .server_time_us = wire_time(now)}),
        Delivery::Ordered);
    for (const protocol::SharedFrame& frame : *missed) around_.outbox.deliver(to, frame, delivery);
}

void Table::announce_seats(base::Instant now, std::optional<SessionId> except) {
    announce_spectators_at_.reset();
    publish(
        now,
        numbered(say::SeatChanged{.sequence = {},
                                  .seats = seat_views(),
                                  .spectators = static_cast<std::uint32_t>(seating_.spectators())}),
        except);
}

void Table::announce_turn(base::Instant now, std::optional<SessionId> except) {
    publish(now,
            numbered(say::TurnOpened{
                .sequence = {}, .number = match_->state.turn, .turn = clock_.view()}),
            except);
}

void Table::announce_start(base::Instant now) {
    publish(now, numbered(say::MatchStarted{
                     .sequence = {}, .state = match_->state, .turn = clock_.view()}));
}

void Table::announce_shot(base::Instant struck, Step step, const Committed& committed) {
    const auto& command = std::get<match::TakeShot>(step.entry.command);
    const protocol::SharedFrame frame =
        numbered(say::ShotPlayed{.sequence = {},
                                 .struck_us = wire_time(struck),
                                 .seat = step.entry.seat,
                                 .shot_id = step.entry.shot_id,
                                 .shot = command.shot,
                                 .call = command.call,
                                 .record = std::move(*step.entry.record),
                                 .verdict = std::move(*step.entry.verdict),
                                 .after = std::move(step.next),
                                 .turn = clock_.view(),
                                 .commit_us = wire_duration_us(committed.took)});
    rolling_ = Rolling{.sequence = sequence_, .frame = frame, .rests = clock_.opens()};
    match_->last_shots[step.entry.seat] = {step.entry.shot_id, frame};
    publish(struck, frame);
}

void Table::announce_move(base::Instant now, Step step) {
    if (const auto* placed = std::get_if<match::PlaceCueBall>(&step.entry.command)) {
        publish(now,
                numbered(say::CueBallPlaced{
                    .sequence = {}, .seat = step.entry.seat, .position_m = placed->position_m}));
        return;
    }
    say::MatchMoved moved{.sequence = {},
                          .seat = step.entry.seat,
                          .choice = {},
                          .verdict = std::move(step.entry.verdict),
                          .after = std::move(step.next),
                          .turn = clock_.view(),
                          .move = protocol::move_of(step.entry.command)};
    if (const auto* choose = std::get_if<match::Choose>(&step.entry.command)) {
        moved.choice = choose->choice;
    }
    publish(now, numbered(std::move(moved)));
}

void Table::announce_over(base::Instant now, protocol::server::Ending ending) {
    const match::MatchState& state = match_->state;
    publish(now, numbered(say::MatchOver{.sequence = {},
                                         .winner = state.winner,
                                         .racks_won = state.racks_won,
                                         .shots = static_cast<std::uint32_t>(state.shots_played),
                                         .ending = ending}));
}

void Table::announce_change(base::Instant now) {
    publish(now, numbered(say::TableChanged{.sequence = {}, .row = row_now()}));
}

/// Everyone is told; who asked learns which request it was.
void Table::announce_storage_failed(base::Instant now, const std::optional<Asker>& asker) {
    static constexpr auto kCode = protocol::RefusedCode::StorageFailed;
    const std::string detail = "the last step could not be stored, and was undone";
    seating_.for_each_player([&](SessionId to) {
        const bool asked = asker && asker->session == to;
        refuse(around_, {to, asked ? asker->request_id : 0}, kCode, detail);
    });
    const auto frame =
        protocol::encode(say::Refused{.code = kCode, .match_code = {}, .detail = detail});
    show_spectators(now, frame, Delivery::Sheddable);
}

void Table::announce_closing() {
    const protocol::SharedFrame frame = protocol::encode(say::Notice{
        .code = say::NoticeCode::TableClosed, .detail = "no player has been here for too long"});
    const auto tell = [&](SessionId to) { around_.outbox.deliver(to, frame, Delivery::Ordered); };
    seating_.for_each_player(tell);
    seating_.for_each_spectator(tell);
}

model::PerSeat<say::SeatView> Table::seat_views() const {
    auto views = seating_.views();
    if (is_between_matches()) return views;
    for (const model::Seat seat : model::kSeats) {
        if (const auto ends = absence_.ends(seat)) views[seat].claimable_us = wire_time(*ends);
    }
    return views;
}

}  // namespace billiards::server
