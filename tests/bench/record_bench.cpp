// Measures what is done with a solved break: evaluated, hashed, encoded, judged.
#include "common/base/random.h"
#include "common/physics/simulate.h"
#include "common/protocol/codec_journal.h"
#include "common/rules/facts.h"
#include "common/rules/ruleset.h"
#include "common/timeline/evaluate.h"
#include "tools/sim/bench_shots.h"

#include <array>
#include <benchmark/benchmark.h>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace billiards {
namespace {

timeline::ShotRecord break_record() {
    tools::BenchShots shots(tools::BenchCase::Break8);
    const auto [layout, shot] = shots.next();
    auto record = physics::simulate_shot(shots.table(), {}, layout, shot);
    CHECK(record.ok());
    return *std::move(record);
}

/// A ball at random times of a track of state.range(0) segments.
void EvaluateTrack(benchmark::State& state) {
    timeline::BallTrack track;
    const auto count = static_cast<double>(state.range(0));
    for (double start_s = 0.0; start_s < count; ++start_s) {
        track.segments.push_back({.start_s = start_s, .motion = model::Motion::Rolling});
    }
    base::Random random(1);
    std::array<double, 1024> times_s;
    for (double& time_s : times_s) time_s = random.uniform(0.0, count);
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(timeline::evaluate(track, times_s[i++ % times_s.size()]));
    }
    state.SetComplexityN(state.range(0));
}
BENCHMARK(EvaluateTrack)->RangeMultiplier(8)->Range(1, 1 << 12)->Complexity(benchmark::oLogN);

void HashRecord(benchmark::State& state) {
    const timeline::ShotRecord record = break_record();
    for (auto _ : state) benchmark::DoNotOptimize(timeline::hash_of(record));
}
BENCHMARK(HashRecord)->Unit(benchmark::kMicrosecond);

void EncodeRecord(benchmark::State& state) {
    const timeline::ShotRecord record = break_record();
    std::size_t bytes = 0;
    for (auto _ : state) bytes = protocol::encoded_record_size(record);
    state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(EncodeRecord)->Unit(benchmark::kMicrosecond);

void JudgeBreak(benchmark::State& state) {
    const timeline::ShotRecord record = break_record();
    rules::RackState rack;
    for (std::uint8_t number = 1; number <= 15; ++number) rack.on_table.insert({number});
    const rules::Ruleset& game = rules::ruleset_of(rules::Game::EightBall);
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            game.judge(rack, {}, model::NoCall{}, rules::facts_of(record.events)));
    }
}
BENCHMARK(JudgeBreak);

}  // namespace
}  // namespace billiards
