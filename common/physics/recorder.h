// Takes what happens during a shot; gives its record.
#pragma once

#include "common/model/shot_event.h"
#include "common/physics/mover.h"
#include "common/timeline/shot_record.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace billiards::physics {

/// Collects events and segments in order of time. Balls are named by their index.
class Recorder {
  public:
    explicit Recorder(std::span<const Mover> movers);

    void add(const model::ShotEvent& event) { record_.events.push_back(event); }
    /// The ball's plan from now on. A second one at the same instant replaces the first.
    void add_segment(std::size_t ball, const timeline::Segment& segment);

    /// The whole record, hash included. Leaves nothing behind. Head-string events of the cue ball
    /// are found here, from its finished track. `absent` balls took no part.
    timeline::ShotRecord finish(double duration_s, std::optional<double> head_string_m,
                                std::span<const model::PlacedBall> absent);

  private:
    void add_absent(const model::PlacedBall& placed);
    void sort_balls();

    timeline::ShotRecord record_;
};

}  // namespace billiards::physics
