// Takes the cue ball's finished track; gives when it crossed the head string.
#pragma once

#include "common/model/shot_event.h"
#include "common/timeline/timeline.h"

#include <vector>

namespace billiards::physics {

/// Puts a head-string event into `events`, which are in order of time, for each time at which the
/// ball's centre changes sides of the line x = line_m. A ball that starts on the line starts beyond
/// it: only strictly behind is behind (WPA).
void add_head_string_events(const timeline::BallTrack& track, double line_m, double until_s,
                            std::vector<model::ShotEvent>& events);

}  // namespace billiards::physics
