// Takes the name of a kind of shot and a time; gives how fast the engine solves such shots.
#pragma once

#include "tools/sim/json_node.h"

#include <cstdint>

namespace billiards::tools {

enum class BenchCase : std::uint8_t {
    Break8,  ///< 8 ft, frozen triangle, power 0.7 - 1, angle +-1 degree, tip offset within 0.2.
    Break9,  ///< The same on 9 ft with a frozen diamond of nine.
    Mid,     ///< 8 ft, nine balls at random, the cue ball sent off at 3 m/s.
};

/// `billiards-sim bench`: solves shots, every one different, by one fixed seed, until the time is
/// over, 1,000 at least. Time is the processor's, so that a busy machine does not slow it. The
/// digest is over the hashes of those first 1,000, so that it does not depend on the machine's
/// speed.
Json bench(BenchCase bench_case, double seconds);

}  // namespace billiards::tools
