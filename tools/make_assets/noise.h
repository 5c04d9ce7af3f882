// Takes a place on a picture; gives smooth noise that joins itself at the picture's edges, the
// same on every machine.
#pragma once

#include <cstdint>

namespace billiards::make_assets {

/// A repeatable number in [0, 1) for a cell.
double scatter(int x, int y, std::uint64_t seed);

/// Value noise in [0, 1]: random numbers on a lattice of cells_u by cells_v, smooth between them.
/// u and v count in pictures: whole numbers apart is the same place.
double noise(double u, double v, int cells_u, int cells_v, std::uint64_t seed);

/// Octaves of noise, each twice as fine and half as strong as the one before, in [0, 1].
double cloudy(double u, double v, int cells_u, int cells_v, int octaves, std::uint64_t seed);

}  // namespace billiards::make_assets
