// Takes a kind of shot; gives shots a second, time an event and bytes a viewer.
#include "tools/sim/bench.h"

#include "common/base/check.h"
#include "common/base/hash.h"
#include "common/base/hex.h"
#include "common/physics/simulate.h"
#include "common/protocol/codec_journal.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <vector>

namespace billiards::tools {

namespace {

constexpr std::size_t kDigestedShots = 1'000;
constexpr std::size_t kEncodedShots = 500;

std::size_t percentile(std::vector<std::size_t>& values, double share) {
    std::sort(values.begin(), values.end());
    const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    return values[index];
}

Json wire_bytes(BenchCase bench_case) {
    BenchShots shots(bench_case);
    std::vector<std::size_t> sizes;
    while (sizes.size() < kEncodedShots) {
        const auto [layout, shot] = shots.next();
        const auto record = physics::simulate_shot(shots.table(), {}, layout, shot);
        CHECK(record.ok());
        sizes.push_back(protocol::encoded_record_size(*record));
    }
    return {{"p50", percentile(sizes, 0.5)}, {"p99", percentile(sizes, 0.99)}};
}

}  // namespace

Json bench(BenchCase bench_case, double seconds) {
    BenchShots shots(bench_case);
    base::Hasher digest;
    std::vector<std::size_t> events;
    double total_events = 0.0;
    const auto wall_start = std::chrono::steady_clock::now();
    const std::clock_t start = std::clock();
    double cpu_s = 0.0;
    while (cpu_s < seconds || events.size() < kDigestedShots) {
        const auto [layout, shot] = shots.next();
        const auto record = physics::simulate_shot(shots.table(), {}, layout, shot);
        CHECK(record.ok());
        if (events.size() < kDigestedShots) digest.add(record->hash);
        events.push_back(record->events.size());
        total_events += static_cast<double>(record->events.size());
        cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_start;
    const auto count = static_cast<double>(events.size());
    return {{"shots_per_s", count / cpu_s},
            {"events_per_shot", total_events / count},
            {"events", {{"p50", percentile(events, 0.5)}, {"p99", percentile(events, 0.99)}}},
            {"ns_per_event", cpu_s * 1e9 / total_events},
            {"cpu_s", cpu_s},
            {"wall_s", wall.count()},
            {"wire_bytes", wire_bytes(bench_case)},
            {"digest", base::to_hex(digest.digest())}};
}

}  // namespace billiards::tools
