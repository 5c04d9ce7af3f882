// Takes any bytes; gives back nothing, but ends the program where the reader of .3ds files does
// what it must not.
#pragma once

#include <cstddef>
#include <span>

namespace billiards::fuzz {

/// What is read must be drawable: finite places, indices within the vertices, normals one long.
void read_any_model(std::span<const std::byte> bytes);

}  // namespace billiards::fuzz
