// Takes a kind of shot; gives shots a second, time an event and bytes a viewer.
#include "tools/sim/bench.h"

#include "common/base/elementary.h"
#include "common/base/hash.h"
#include "common/base/random.h"
#include "common/model/rack.h"
#include "common/physics/simulate.h"
#include "common/protocol/codec_journal.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

namespace billiards::tools {

namespace {

using model::BallId;
using model::Layout;
using model::Shot;
using model::TableSpec;

constexpr std::uint64_t kSeed = 20;
constexpr std::size_t kDigestedShots = 1'000;
constexpr std::size_t kEncodedShots = 500;
constexpr double kMidSpeed_mps = 3.0;
constexpr int kMidBalls = 9;

struct Position {
    Layout layout;
    Shot shot;
};

/// Makes the shots of a case, one after another.
class Shots {
  public:
    explicit Shots(BenchCase bench_case) : case_(bench_case), random_(kSeed) {}

    const TableSpec& table() const {
        return model::table_of(case_ == BenchCase::Break9 ? model::TableSize::NineFoot
                                                          : model::TableSize::EightFoot);
    }

    Position next() { return case_ == BenchCase::Mid ? mid() : hard_break(); }

  private:
    Position hard_break() {
        Position position{.layout = rack(), .shot = {}};
        position.shot.power = random_.uniform(0.7, 1.0);
        position.shot.angle_rad = base::radians(random_.uniform(-1.0, 1.0));
        constexpr double kOffset = 0.2;
        do {
            position.shot.tip_left = random_.uniform(-kOffset, kOffset);
            position.shot.tip_up = random_.uniform(-kOffset, kOffset);
        } while (std::hypot(position.shot.tip_left, position.shot.tip_up) > kOffset);
        return position;
    }

    Layout rack() const {
        const std::vector<base::Vec2> triangle =
            model::triangle_positions(table(), model::BallSpec{}.radius_m);
        // Rows of 1, 2, 3, 2, 1: the diamond within the triangle.
        static constexpr std::size_t kDiamond[] = {0, 1, 2, 3, 4, 5, 7, 8, 12};
        Layout layout{{{.ball = model::kCueBall, .position_m = model::head_spot(table())}}};
        for (std::size_t i = 0; i < triangle.size(); ++i) {
            const bool is_in_diamond = std::count(std::begin(kDiamond), std::end(kDiamond), i) > 0;
            if (case_ == BenchCase::Break9 && !is_in_diamond) continue;
            const auto number = static_cast<std::uint8_t>(layout.balls.size());
            layout.balls.push_back({.ball = BallId{number}, .position_m = triangle[i]});
        }
        return layout;
    }

    Position mid() {
        const base::Vec2 reach = table().half_playing_m - 2.5 * model::BallSpec{}.radius_m;
        Position position;
        while (position.layout.balls.size() < kMidBalls) {
            const base::Vec2 place{random_.uniform(-reach.x, reach.x),
                                   random_.uniform(-reach.y, reach.y)};
            const bool is_free = std::all_of(
                position.layout.balls.begin(), position.layout.balls.end(), [&](const auto& other) {
                    return glm::distance(other.position_m, place) > 2 * model::BallSpec{}.radius_m;
                });
            if (!is_free) continue;
            const auto number = static_cast<std::uint8_t>(position.layout.balls.size());
            position.layout.balls.push_back({.ball = BallId{number}, .position_m = place});
        }
        const physics::Parameters parameters;
        position.shot.power = kMidSpeed_mps * model::BallSpec{}.mass_kg /
                              (parameters.cue_spring_npm * parameters.cue_contact_time_s);
        position.shot.angle_rad = random_.uniform(-base::kPi, base::kPi);
        return position;
    }

    BenchCase case_;
    base::Random random_;
};

std::size_t percentile(std::vector<std::size_t>& values, double share) {
    std::sort(values.begin(), values.end());
    const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    return values[index];
}

Json wire_bytes(BenchCase bench_case) {
    Shots shots(bench_case);
    std::vector<std::size_t> sizes;
    while (sizes.size() < kEncodedShots) {
        const Position position = shots.next();
        const auto record =
            physics::simulate_shot(shots.table(), {}, position.layout, position.shot);
        CHECK(record.ok());
        sizes.push_back(protocol::encoded_record_size(*record));
    }
    return {{"p50", percentile(sizes, 0.5)}, {"p99", percentile(sizes, 0.99)}};
}

}  // namespace

Json bench(BenchCase bench_case, double seconds) {
    Shots shots(bench_case);
    base::Hasher digest;
    std::vector<std::size_t> events;
    double total_events = 0.0;
    const std::clock_t start = std::clock();
    double elapsed_s = 0.0;
    while (elapsed_s < seconds || events.size() < kDigestedShots) {
        const Position position = shots.next();
        const auto record =
            physics::simulate_shot(shots.table(), {}, position.layout, position.shot);
        CHECK(record.ok());
        if (events.size() < kDigestedShots) digest.add(record->hash);
        events.push_back(record->events.size());
        total_events += static_cast<double>(record->events.size());
        elapsed_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    const auto count = static_cast<double>(events.size());
    char digest_text[17];
    std::snprintf(digest_text, sizeof digest_text, "%016" PRIx64, digest.digest());
    return {{"shots_per_s", count / elapsed_s},
            {"events_per_shot", total_events / count},
            {"events", {{"p50", percentile(events, 0.5)}, {"p99", percentile(events, 0.99)}}},
            {"ns_per_event", elapsed_s * 1e9 / total_events},
            {"wire_bytes", wire_bytes(bench_case)},
            {"digest", digest_text}};
}

}  // namespace billiards::tools
