// Measures the codec on what a newcomer gets: a snapshot of a table, at rest and with a shot
// rolling.
#include "common/match/match.h"
#include "common/physics/simulate.h"
#include "common/protocol/codec.h"
#include "common/protocol/limits.h"
#include "tools/sim/bench_shots.h"

#include <benchmark/benchmark.h>
#include <cstddef>
#include <span>
#include <utility>

namespace billiards::protocol {
namespace {

server::TableSnapshot snapshot_at_rest() {
    auto state = match::start({}, 1);
    CHECK(state.ok());
    server::TableSnapshot snapshot;
    snapshot.row.name = "benchmark";
    snapshot.your_seats = {model::Seat::First};
    snapshot.match = *state;
    return snapshot;
}

server::TableSnapshot snapshot_rolling() {
    tools::BenchShots shots(tools::BenchCase::Break8);
    const auto [layout, shot] = shots.next();
    auto record = physics::simulate_shot(shots.table(), {}, layout, shot);
    CHECK(record.ok());
    server::TableSnapshot snapshot = snapshot_at_rest();
    server::ShotPlayed& played = snapshot.rolling.emplace();
    played.shot = shot;
    played.record = *std::move(record);
    played.after = *snapshot.match;
    return snapshot;
}

void EncodeSnapshot(benchmark::State& state, server::TableSnapshot (*make)()) {
    const ServerMessage message = make();
    std::size_t bytes = 0;
    for (auto _ : state) bytes = encode(message)->size();
    state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK_CAPTURE(EncodeSnapshot, AtRest, snapshot_at_rest);
BENCHMARK_CAPTURE(EncodeSnapshot, Rolling, snapshot_rolling);

void DecodeSnapshot(benchmark::State& state, server::TableSnapshot (*make)()) {
    const SharedFrame frame = encode(ServerMessage{make()});
    for (auto _ : state) {
        const auto decoded = decode_server(std::span(*frame).subspan(kFrameHeaderBytes));
        CHECK(decoded.ok());
    }
}
BENCHMARK_CAPTURE(DecodeSnapshot, AtRest, snapshot_at_rest);
BENCHMARK_CAPTURE(DecodeSnapshot, Rolling, snapshot_rolling);

}  // namespace
}  // namespace billiards::protocol
