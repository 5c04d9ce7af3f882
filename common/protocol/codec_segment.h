// Takes a segment and gives the few 32-bit numbers that it can be restored from, and back, without
// physics: what can be left out are zeros, the rest height, and spins that follow from velocities
// by a fixed factor.
#pragma once

#include "common/timeline/timeline.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace billiards::protocol {

/// What all segments of a track, or of a record, have in common.
struct SegmentContext {
    double radius_m = 0.0;
    /// The size of the rate at which spins about the vertical decay; a 32-bit number.
    double twist_rate_radps2 = 0.0;
};

/// Appends the numbers of `segment` and gives its form: motion and what the numbers are.
/// The start is not among them.
std::uint8_t pack(const timeline::Segment& segment, const SegmentContext& context,
                  std::vector<float>& numbers);

/// Takes its numbers from the front of `numbers`. None where the form is unknown or numbers are
/// missing; start_s stays 0.
std::optional<timeline::Segment> unpack(std::uint8_t form, const SegmentContext& context,
                                        std::span<const float>& numbers);

}  // namespace billiards::protocol
