// Takes any bytes; gives back nothing, but ends the program where a decoder does what it must not.
#pragma once

#include <cstddef>
#include <span>

namespace billiards::fuzz {

/// Every decoder gets the bytes. What one accepts must survive being encoded and decoded again,
/// and a timeline in it must be playable.
void decode_anything(std::span<const std::byte> bytes);

}  // namespace billiards::fuzz
