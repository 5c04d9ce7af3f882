// Measures what a kept match costs: to write, open, play and verify it, and to pack its shots.
#include "common/protocol/packing.h"
#include "common/replay/play.h"
#include "common/replay/replay_file.h"
#include "common/replay/verify.h"
#include "tests/common/replay/bot_match.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstddef>
#include <vector>

namespace billiards {
namespace {

std::size_t shots_in(const replay::Replay& replay) {
    return static_cast<std::size_t>(
        std::ranges::count_if(replay.entries, [](const protocol::JournalEntry& entry) {
            return std::holds_alternative<match::TakeShot>(entry.command);
        }));
}

constexpr std::size_t kLong = 2'000;

/// The start of a long match of eight-ball, with this many shots.
replay::Replay match_of(std::size_t shots) {
    static const replay::Replay whole = replay::bot_match(replay::race_to(50), 1, 2 * kLong);
    replay::Replay replay = whole;
    while (shots_in(replay) > shots) replay.entries.pop_back();
    return replay;
}

void note(benchmark::State& state, const replay::Replay& replay) {
    const auto shots = static_cast<double>(shots_in(replay));
    const auto bytes = static_cast<double>(replay::to_bytes(replay)->size());
    replay::Replay bare = replay;
    for (protocol::JournalEntry& entry : bare.entries) entry.record.reset();
    const auto bare_bytes = static_cast<double>(replay::to_bytes(bare)->size());
    state.counters["shots"] = shots;
    state.counters["bytes_a_shot"] = bytes / shots;
    state.counters["without_record"] = bare_bytes / shots;
}

void WriteReplay(benchmark::State& state) {
    const replay::Replay replay = match_of(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(replay::to_bytes(replay));
    note(state, replay);
}

void ReadReplay(benchmark::State& state) {
    const replay::Replay replay = match_of(static_cast<std::size_t>(state.range(0)));
    const protocol::Bytes bytes = replay::to_bytes(replay).value();
    for (auto _ : state) benchmark::DoNotOptimize(replay::from_bytes(bytes));
    note(state, replay);
}

void PlayReplay(benchmark::State& state) {
    const replay::Replay replay = match_of(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        benchmark::DoNotOptimize(replay::play(replay, [](const replay::Moment&) {}));
    }
    note(state, replay);
}

void VerifyReplay(benchmark::State& state) {
    const replay::Replay replay = match_of(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(replay::verify(replay));
    note(state, replay);
}

/// What the store's thread does for each shot.
void PackShot(benchmark::State& state) {
    const replay::Replay replay = match_of(300);
    std::vector<protocol::EncodedEntry> entries;
    for (const protocol::JournalEntry& entry : replay.entries) {
        if (entry.record) entries.push_back(protocol::encode_entry(entry));
    }
    std::size_t at = 0;
    double record_bytes = 0;
    double layout_bytes = 0;
    double other_bytes = 0;
    for (auto _ : state) {
        const protocol::EncodedEntry& entry = entries[at++ % entries.size()];
        record_bytes += static_cast<double>(protocol::packed(entry.record).size());
        layout_bytes += static_cast<double>(protocol::packed(entry.final_layout).size());
        other_bytes += static_cast<double>(entry.command.size() + entry.verdict.size());
    }
    const auto mean = benchmark::Counter::kAvgIterations;
    state.counters["record_bytes"] = benchmark::Counter(record_bytes, mean);
    state.counters["layout_bytes"] = benchmark::Counter(layout_bytes, mean);
    state.counters["other_bytes"] = benchmark::Counter(other_bytes, mean);
}

BENCHMARK(WriteReplay)->Arg(30)->Unit(benchmark::kMillisecond);
BENCHMARK(ReadReplay)->Arg(30)->Arg(kLong)->Unit(benchmark::kMillisecond);
BENCHMARK(PlayReplay)->Arg(30)->Arg(kLong)->Unit(benchmark::kMillisecond);
BENCHMARK(VerifyReplay)->Arg(30)->Arg(kLong)->Unit(benchmark::kMillisecond);
BENCHMARK(PackShot)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace billiards
