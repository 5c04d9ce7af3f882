// Takes and gives what the lobby and a table show on the wire. For codec*.cpp only.
#pragma once

#include "common/protocol/messages.h"
#include "proto/server.capnp.h"

#include <vector>

namespace billiards::protocol {

void write(wire::SeatView::Builder out, const server::SeatView& seat);
void write(wire::TableRow::Builder out, const server::TableRow& row);
void write(wire::Turn::Builder out, const server::Turn& turn);
void write(wire::ShotPlayed::Builder out, const server::ShotPlayed& played);
void write(wire::TableSnapshot::Builder out, const server::TableSnapshot& snapshot);
/// As many as there is room for.
void write(capnp::List<wire::Seat>::Builder out, const std::vector<model::Seat>& seats);

server::SeatView read(wire::SeatView::Reader in);
server::TableRow read(wire::TableRow::Reader in);
server::Turn read(wire::Turn::Reader in);
server::ShotPlayed read(wire::ShotPlayed::Reader in);
server::TableSnapshot read(wire::TableSnapshot::Reader in);
std::vector<model::Seat> read_your_seats(capnp::List<wire::Seat>::Reader in);

/// A shot that has been accepted has only finite numbers.
model::Shot finite(const model::Shot& shot);

}  // namespace billiards::protocol
