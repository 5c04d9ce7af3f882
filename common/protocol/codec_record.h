// Takes and gives the record of a shot on the wire. For codec*.cpp only.
#pragma once

#include "common/timeline/shot_record.h"
#include "proto/model.capnp.h"

namespace billiards::protocol {

void write(wire::ShotRecord::Builder out, const timeline::ShotRecord& record);
/// Refuses what could not be played back: a number that is not finite, a track without a segment,
/// times that go back. Does not check the hash: it is of the record before its rounding.
timeline::ShotRecord read(wire::ShotRecord::Reader in);

}  // namespace billiards::protocol
