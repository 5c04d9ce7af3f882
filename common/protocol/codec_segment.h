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

/// A number as it arrives: rounded to 32 bits.
double as_sent(double number);

/// Appends the numbers of `segment` and gives its form: motion and what the numbers are.
/// The start is not among them.
std::uint8_t pack(const timeline::Segment& segment, double radius_m, std::vector<float>& numbers);

/// Takes its numbers from the front of `numbers`. None where the form is unknown or numbers are
/// missing; start_s stays 0.
std::optional<timeline::Segment> unpack(std::uint8_t form, double radius_m,
                                        std::span<const float>& numbers);

}  // namespace billiards::protocol
