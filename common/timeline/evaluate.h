// Takes a timeline and a time; gives the balls at that time, in O(log n) a ball.
#pragma once

#include "common/model/ball.h"
#include "common/timeline/timeline.h"

namespace billiards::timeline {

/// The state of a segment at time_s. Times before its start are taken as its start.
model::BallState evaluate(const Segment& segment, double time_s);

/// The state of a ball at time_s; before 0 as at 0, after the end as at rest at the end.
/// The track must have a segment.
model::BallState evaluate(const BallTrack& track, double time_s);

}  // namespace billiards::timeline
