// Takes and gives what the lobby and a table show on the wire.
#include "common/protocol/codec_table.h"

#include "common/protocol/codec_enums.h"
#include "common/protocol/codec_match.h"
#include "common/protocol/codec_message.h"
#include "common/protocol/codec_model.h"
#include "common/protocol/codec_record.h"

namespace billiards::protocol {

void write(wire::SeatView::Builder out, const server::SeatView& seat) {
    out.setTaken(seat.taken);
    out.setConnected(seat.connected);
    out.setReady(seat.ready);
    out.setName(seat.name);
    if (seat.claimable_us) out.getClaimable().setUs(*seat.claimable_us);
}

server::SeatView read(wire::SeatView::Reader in) {
    server::SeatView seat{.taken = in.getTaken(),
                          .connected = in.getConnected(),
                          .ready = in.getReady(),
                          .name = text(in.getName(), kMaxShownNameLength, "name")};
    if (in.getClaimable().isUs()) seat.claimable_us = in.getClaimable().getUs();
    return seat;
}

void write(wire::TableRow::Builder out, const server::TableRow& row) {
    out.setTable(row.table.value);
    out.setName(row.name);
    write(out.initSettings(), row.settings);
    write(out.initFirstSeat(), row.seats[model::Seat::First]);
    write(out.initSecondSeat(), row.seats[model::Seat::Second]);
    write_counts(out.getRacksWon(), row.racks_won);
    out.setPlaying(row.playing);
    out.setSpectators(row.spectators);
    out.setIsPrivate(row.is_private);
    out.setHasPasscode(row.has_passcode);
    out.setOwner(row.owner);
}

server::TableRow read(wire::TableRow::Reader in) {
    return {.table = TableId{in.getTable()},
            .name = text(in.getName(), kMaxTableNameLength, "name"),
            .settings = accepted_settings(in.getSettings()),
            .seats = {{read(in.getFirstSeat()), read(in.getSecondSeat())}},
            .racks_won = read_counts(in.getRacksWon(), "racks_won"),
            .playing = in.getPlaying(),
            .spectators = in.getSpectators(),
            .is_private = in.getIsPrivate(),
            .has_passcode = in.getHasPasscode(),
            .owner = text(in.getOwner(), kMaxShownNameLength, "owner")};
}

void write(wire::Turn::Builder out, const server::Turn& turn) {
    out.setOpensUs(turn.opens_us);
    if (turn.deadline_us) out.getDeadline().setUs(*turn.deadline_us);
}

server::Turn read(wire::Turn::Reader in) {
    server::Turn turn{.opens_us = in.getOpensUs(), .deadline_us = {}};
    if (in.getDeadline().isUs()) turn.deadline_us = in.getDeadline().getUs();
    return turn;
}

void write(wire::ShotPlayed::Builder out, const server::ShotPlayed& played) {
    out.setSequence(played.sequence);
    out.setStruckUs(played.struck_us);
    out.setSeat(to_wire(played.seat));
    out.setShotId(played.shot_id);
    write(out.initShot(), played.shot);
    write(out.initCall(), played.call);
    write(out.initRecord(), played.record);
    write(out.initVerdict(), played.verdict);
    write(out.initAfter(), played.after);
    write(out.initTurn(), played.turn);
    out.setCommitUs(played.commit_us);
}

server::ShotPlayed read(wire::ShotPlayed::Reader in) {
    return {.sequence = in.getSequence(),
            .struck_us = in.getStruckUs(),
            .seat = read(in.getSeat()),
            .shot_id = in.getShotId(),
            .shot = finite(read(in.getShot())),
            .call = read(in.getCall()),
            .record = read(in.getRecord()),
            .verdict = read(in.getVerdict()),
            .after = read(in.getAfter()),
            .turn = read(in.getTurn()),
            .commit_us = in.getCommitUs()};
}

void write(capnp::List<wire::Seat>::Builder out, const std::vector<model::Seat>& seats) {
    for (unsigned int i = 0; i < out.size(); ++i) out.set(i, to_wire(seats[i]));
}

std::vector<model::Seat> read_your_seats(capnp::List<wire::Seat>::Reader in) {
    std::vector<model::Seat> seats;
    for (const auto seat : at_most(in, model::kSeats.size(), "your_seats")) {
        seats.push_back(read(seat));
    }
    return seats;
}

void write(wire::TableSnapshot::Builder out, const server::TableSnapshot& snapshot) {
    out.setSequence(snapshot.sequence);
    write(out.initRow(), snapshot.row);
    write(out.initYourSeats(static_cast<unsigned int>(snapshot.your_seats.size())),
          snapshot.your_seats);
    if (snapshot.match) write(out.getMatch().initState(), *snapshot.match);
    if (snapshot.rolling) write(out.getRolling().initShot(), *snapshot.rolling);
    write(out.initTurn(), snapshot.turn);
    out.setServerTimeUs(snapshot.server_time_us);
    out.setStream(snapshot.stream);
}

server::TableSnapshot read(wire::TableSnapshot::Reader in) {
    server::TableSnapshot snapshot{.sequence = in.getSequence(),
                                   .row = read(in.getRow()),
                                   .your_seats = read_your_seats(in.getYourSeats()),
                                   .match = {},
                                   .rolling = {},
                                   .turn = read(in.getTurn()),
                                   .server_time_us = in.getServerTimeUs(),
                                   .stream = in.getStream()};
    if (in.getMatch().isState()) snapshot.match = read(in.getMatch().getState());
    if (in.getRolling().isShot()) snapshot.rolling = read(in.getRolling().getShot());
    return snapshot;
}

model::Shot finite(const model::Shot& shot) {
    for (const double number :
         {shot.angle_rad, shot.power, shot.tip_left, shot.tip_up, shot.elevation_rad}) {
        finite(number, "shot");
    }
    return shot;
}

}  // namespace billiards::protocol
