// Holds that a benchmark measures what it says, and the same shots each time.
#include "tools/sim/bench.h"

#include <gtest/gtest.h>

namespace billiards::tools {
namespace {

TEST(Bench, SolvesTheSameShotsEachTime) {
    const Json first = bench(BenchCase::Mid, 0.0);
    const Json second = bench(BenchCase::Mid, 0.0);
    EXPECT_EQ(first["digest"], second["digest"]);
    EXPECT_GT(first["shots_per_s"].get<double>(), 0.0);
    EXPECT_GT(first["events_per_shot"].get<double>(), 5.0);
    EXPECT_GT(first["wire_bytes"]["p99"].get<double>(), first["wire_bytes"]["p50"].get<double>());
}

TEST(Bench, BreaksDifferFromCaseToCase) {
    const Json eight = bench(BenchCase::Break8, 0.0);
    const Json nine = bench(BenchCase::Break9, 0.0);
    EXPECT_NE(eight["digest"], nine["digest"]);
    EXPECT_GT(eight["events_per_shot"].get<double>(), nine["events_per_shot"].get<double>());
    EXPECT_LE(eight["wire_bytes"]["p50"].get<int>(), 12'288);
}

}  // namespace
}  // namespace billiards::tools
