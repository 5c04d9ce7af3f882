// Takes what happened at a table; gives each frame, encoded once, to everyone who is there.
#include "common/base/check.h"
#include "common/protocol/codec.h"
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

void Table::deliver_to_all(const protocol::SharedFrame& frame, std::optional<SessionId> except) {
    const auto deliver = [&](SessionId to) {
        if (to != except) around_.outbox.deliver(to, frame, Delivery::Ordered);
    };
    seating_.for_each_player(deliver);
    seating_.for_each_spectator(deliver);
}

void Table::broadcast(const protocol::ServerMessage& message, std::optional<SessionId> except) {
    deliver_to_all(protocol::encode(message), except);
}

void Table::send_snapshot(base::Instant now, SessionId to) {
    say::TableSnapshot snapshot{.sequence = sequence_,
                                .row = row(),
                                .your_seats = seating_.seats_of(to),
                                .match = {},
                                .rolling = {},
                                .turn = clock_.view(),
                                .server_time_us = wire_time(now)};
    if (match_) snapshot.match = match_->state;
    if (rolling_ && now < rolling_->rests) snapshot.rolling = rolling_->played;
    around_.outbox.deliver(to, protocol::encode(std::move(snapshot)), Delivery::Ordered);
}

void Table::announce_seats(std::optional<SessionId> except) {
    announce_spectators_at_.reset();
    broadcast(say::SeatChanged{.sequence = ++sequence_,
                               .seats = seating_.views(),
                               .spectators = static_cast<std::uint32_t>(seating_.spectators())},
              except);
}

void Table::announce_turn(std::optional<SessionId> except) {
    broadcast(
        say::TurnOpened{
            .sequence = ++sequence_, .number = match_->state.turn, .turn = clock_.view()},
        except);
}

void Table::announce_start() {
    broadcast(
        say::MatchStarted{.sequence = ++sequence_, .state = match_->state, .turn = clock_.view()});
}

void Table::announce_placement(const Step& step) {
    broadcast(say::CueBallPlaced{
        .sequence = ++sequence_,
        .seat = step.entry.seat,
        .position_m = std::get<match::PlaceCueBall>(step.entry.command).position_m});
}

void Table::announce_shot(base::Instant struck, Step step, const Committed& committed) {
    const auto& command = std::get<match::TakeShot>(step.entry.command);
    say::ShotPlayed played{.sequence = ++sequence_,
                           .struck_us = wire_time(struck),
                           .seat = step.entry.seat,
                           .shot_id = step.entry.shot_id,
                           .shot = command.shot,
                           .call = command.call,
                           .record = std::move(*step.entry.record),
                           .verdict = std::move(*step.entry.verdict),
                           .after = std::move(step.next),
                           .turn = clock_.view(),
                           .commit_us = wire_duration_us(committed.took)};
    const protocol::SharedFrame frame = protocol::encode(played);
    match_->last_shots[played.seat] = {played.shot_id, frame};
    rolling_ = Rolling{.played = std::move(played), .rests = clock_.opens()};
    deliver_to_all(frame);
}

void Table::announce_move(Step step) {
    say::MatchMoved moved{.sequence = ++sequence_,
                          .seat = step.entry.seat,
                          .choice = {},
                          .verdict = std::move(step.entry.verdict),
                          .after = std::move(step.next),
                          .turn = clock_.view()};
    if (const auto* choose = std::get_if<match::Choose>(&step.entry.command)) {
        moved.choice = choose->choice;
    }
    broadcast(std::move(moved));
}

void Table::announce_over(protocol::server::Ending ending) {
    const match::MatchState& state = match_->state;
    broadcast(say::MatchOver{.sequence = ++sequence_,
                             .winner = state.winner,
                             .racks_won = state.racks_won,
                             .shots = static_cast<std::uint32_t>(state.shots_played),
                             .ending = ending});
}

/// Everyone is told; who asked learns which request it was.
void Table::announce_storage_failed(const std::optional<Asker>& asker) {
    const auto tell = [&](SessionId to) {
        const bool asked = asker && asker->session == to;
        refuse(around_, {to, asked ? asker->request_id : 0}, protocol::RefusedCode::StorageFailed,
               "the last step could not be stored, and was undone");
    };
    seating_.for_each_player(tell);
    seating_.for_each_spectator(tell);
}

void Table::close() {
    CHECK(!is_pending());
    broadcast(say::Notice{.code = say::NoticeCode::TableClosed,
                          .detail = "no player has been here for too long"});
    if (!is_playing()) return;
    around_.committer.submit({FinishMatch{match_->id}},
                             [&around = around_](const Committed& committed) {
                                 around.stats.storage_failing = !committed.result.ok();
                             });
}

}  // namespace billiards::server
