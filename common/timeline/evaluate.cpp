// Takes segments and a time; gives position, velocity and spin by the formulas of timeline.h.
#include "common/timeline/evaluate.h"

#include "common/base/check.h"

#include <algorithm>

namespace billiards::timeline {

namespace {

/// A spin about the vertical that decays towards 0, and stays there.
double vertical_spin(double spin_radps, double rate_radps2, double elapsed_s) {
    const double spin = spin_radps + rate_radps2 * elapsed_s;
    const bool has_turned = (spin_radps > 0 && spin < 0) || (spin_radps < 0 && spin > 0);
    return has_turned || spin_radps == 0 ? 0.0 : spin;
}

}  // namespace

model::BallState evaluate(const Segment& segment, double time_s) {
    const double elapsed = std::max(0.0, time_s - segment.start_s);
    base::Vec3 spin = segment.spin_radps + segment.spin_rate_radps2 * elapsed;
    spin.z = vertical_spin(segment.spin_radps.z, segment.spin_rate_radps2.z, elapsed);
    return {
        .position_m = segment.position_m +
                      (segment.velocity_mps + segment.acceleration_mps2 * (elapsed / 2)) * elapsed,
        .velocity_mps = segment.velocity_mps + segment.acceleration_mps2 * elapsed,
        .spin_radps = spin,
        .motion = segment.motion};
}

model::BallState evaluate(const BallTrack& track, double time_s) {
    CHECK(!track.segments.empty());
    const auto after = std::upper_bound(
        track.segments.begin(), track.segments.end(), time_s,
        [](double time, const Segment& segment) { return time < segment.start_s; });
    return evaluate(after == track.segments.begin() ? *after : *(after - 1), time_s);
}

}  // namespace billiards::timeline
