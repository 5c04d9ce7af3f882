// Gives a shot as formulas: for each ball a list of pieces, each a polynomial of degree two in
// time. Whoever holds one can say where every ball is at any time, without the engine.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"

#include <span>
#include <vector>

namespace billiards::timeline {

/// From start_s until the next segment of the same ball starts:
///   position = position_m + velocity_mps dt + acceleration_mps2 dt^2 / 2
///   spin     = spin_radps + spin_rate_radps2 dt
/// with dt = t - start_s, but that the vertical part of the spin stays 0 once it has come to 0:
/// it may end before the segment does, and starts no segment of its own.
struct Segment {
    double start_s = 0.0;
    base::Vec3 position_m{};
    base::Vec3 velocity_mps{};
    base::Vec3 acceleration_mps2{};
    base::Vec3 spin_radps{};
    base::Vec3 spin_rate_radps2{};
    model::Motion motion = model::Motion::Resting;

    friend bool operator==(const Segment&, const Segment&) = default;
};

/// One ball's segments in order of time; the first starts at 0, the last lasts for ever.
struct BallTrack {
    model::BallId ball;
    double radius_m = 0.0;
    std::vector<Segment> segments;

    friend bool operator==(const BallTrack&, const BallTrack&) = default;
};

/// All balls of a shot, in ascending number.
struct Timeline {
    std::vector<BallTrack> tracks;

    friend bool operator==(const Timeline&, const Timeline&) = default;
};

}  // namespace billiards::timeline
