// Takes the name of a kind of shot and a time; gives how fast the engine solves such shots.
#pragma once

#include "tools/sim/bench_shots.h"
#include "tools/sim/json_node.h"

namespace billiards::tools {

/// `billiards-sim bench`: solves shots, every one different, by one fixed seed, until the time is
/// over, 1,000 at least. Time is this process's on the processor, so that others on a busy machine
/// do not slow it; cpu_s and wall_s show how far the two clocks are apart. The digest is over the
/// hashes of those first 1,000, so that it does not depend on the machine's speed.
Json bench(BenchCase bench_case, double seconds);

}  // namespace billiards::tools
