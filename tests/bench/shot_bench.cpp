// Measures whole shots: breaks, nine balls at random, and two balls alone.
#include "common/physics/simulate.h"
#include "tools/sim/bench_shots.h"

#include <benchmark/benchmark.h>

namespace billiards::physics {
namespace {

using tools::BenchCase;

void Shot(benchmark::State& state, BenchCase bench_case) {
    tools::BenchShots shots(bench_case);
    double events = 0.0;
    for (auto _ : state) {
        const auto [layout, shot] = shots.next();
        const auto record = simulate_shot(shots.table(), {}, layout, shot);
        CHECK(record.ok());
        events += static_cast<double>(record->events.size());
    }
    state.counters["events"] = benchmark::Counter(events, benchmark::Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(Shot, Break8, BenchCase::Break8)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(Shot, Break9, BenchCase::Break9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(Shot, Mid, BenchCase::Mid)->Unit(benchmark::kMicrosecond);

/// A half-ball hit a metre away.
void ShotTwoBalls(benchmark::State& state) {
    constexpr double kRadius_m = model::BallSpec{}.radius_m;
    const model::TableSpec& table = model::table_of(model::TableSize::EightFoot);
    const model::Layout layout{{{.ball = model::kCueBall, .position_m = {-0.5, 0}},
                                {.ball = {1}, .position_m = {0.5, kRadius_m}}}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(simulate_shot(table, {}, layout, {.power = 0.2}));
    }
}
BENCHMARK(ShotTwoBalls)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace billiards::physics
