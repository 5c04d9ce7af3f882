// Takes and gives layouts, shots and calls on the wire. For codec*.cpp only.
#pragma once

#include "common/model/layout.h"
#include "common/model/seat.h"
#include "common/model/shot.h"
#include "proto/model.capnp.h"

namespace billiards::protocol {

void write(wire::Layout::Builder out, const model::Layout& layout);
void write(wire::Shot::Builder out, const model::Shot& shot);
void write(wire::Call::Builder out, const model::Call& call);

model::Layout read(wire::Layout::Reader in);
/// Any number, also NaN: whether it makes sense is asked of the match, which refuses by name.
model::Shot read(wire::Shot::Reader in);
model::Call read(wire::Call::Reader in);

model::Seat read(wire::Seat in);

}  // namespace billiards::protocol
