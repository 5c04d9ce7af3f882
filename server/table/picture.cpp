// Takes what is shown and how late; gives it as it is told.
#include "server/table/picture.h"

#include "common/base/check.h"
#include "common/protocol/framing.h"
#include "server/table/turn_clock.h"

#include <optional>
#include <span>
#include <utility>
#include <variant>

namespace billiards::server {
namespace {

namespace say = protocol::server;

/// One function a message: a new one does not compile until its moments are known.
class Delay {
  public:
    explicit Delay(base::Duration by) : by_us_(by.count()) {}

    void on(say::SeatChanged& message) const { move(message.seats); }
    void on(say::MatchStarted& message) const { move(message.turn); }
    void on(say::ShotPlayed& message) const {
        message.struck_us += by_us_;
        move(message.turn);
    }
    void on(say::TurnOpened& message) const { move(message.turn); }
    void on(say::MatchMoved& message) const { move(message.turn); }
    void on(say::TableChanged& message) const { move(message.row.seats); }
    void on(say::TableSnapshot& message) const {
        move(message.row.seats);
        if (message.rolling) on(*message.rolling);
        move(message.turn);
        message.server_time_us += by_us_;
    }
    void on(say::TableList& message) const {
        for (say::TableRow& row : message.tables) move(row.seats);
    }
    void on(say::TableListChange& message) const {
        for (say::TableRow& row : message.changed) move(row.seats);
    }

    // The time of none of these is the table's, or they have none.
    void on(say::Welcome&) const {}
    void on(say::Refused&) const {}
    void on(say::CueBallPlaced&) const {}
    void on(say::AimShown&) const {}
    void on(say::MatchOver&) const {}
    void on(say::ChatSaid&) const {}
    void on(say::Notice&) const {}
    void on(say::Pong&) const {}
    void on(say::Resumed&) const {}
    void on(say::InviteMade&) const {}
    void on(say::HistoryPage&) const {}
    void on(say::PlayerRecord&) const {}
    void on(say::ReplayChunk&) const {}

  private:
    void move(std::optional<std::int64_t>& time_us) const {
        if (time_us) *time_us += by_us_;
    }
    void move(say::Turn& turn) const {
        turn.opens_us += by_us_;
        move(turn.deadline_us);
    }
    void move(model::PerSeat<say::SeatView>& seats) const {
        for (say::SeatView& seat : seats.values) move(seat.claimable_us);
    }

    std::int64_t by_us_;
};

}  // namespace

say::TableSnapshot snapshot_of(const Picture& picture, base::Instant now) {
    say::TableSnapshot snapshot{.sequence = picture.sequence,
                                .row = picture.row,
                                .your_seats = {},
                                .match = picture.match,
                                .rolling = {},
                                .turn = picture.turn,
                                .server_time_us = wire_time(now)};
    if (picture.rolling && now < picture.rests) {
        snapshot.rolling = std::get<say::ShotPlayed>(message_in(picture.rolling));
    }
    return snapshot;
}

protocol::ServerMessage message_in(const protocol::SharedFrame& frame) {
    auto message = protocol::decode_server(std::span(*frame).subspan(protocol::kFrameHeaderBytes));
    CHECK(message.ok());
    return std::move(message).value();
}

protocol::ServerMessage told_later(protocol::ServerMessage message, base::Duration by) {
    const Delay delay(by);
    std::visit([&delay](auto& body) { delay.on(body); }, message);
    return message;
}

}  // namespace billiards::server
