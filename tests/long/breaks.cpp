// Takes a number of shots; gives their faults and figures.
#include "tests/long/breaks.h"

#include "common/base/hash.h"
#include "tests/common/physics/layouts.h"
#include "tests/common/physics/soundness.h"

#include <algorithm>
#include <iomanip>
#include <optional>
#include <string>
#include <vector>

namespace billiards {

namespace {

using physics::BallStart;
using physics::ScatterKind;

constexpr std::uint64_t kKinds = 8;

struct Case {
    const model::TableSpec& table;
    physics::Parameters parameters;
    std::vector<BallStart> balls;
};

std::vector<BallStart> hard_break(base::Random& random, const model::TableSpec& table) {
    const double speed = random.uniform(8.0, 12.0);
    const double angle = base::radians(random.uniform(-1.5, 1.5));
    base::Vec3 spin{};
    for (int axis = 0; axis < 3; ++axis) spin[axis] = random.uniform(-80.0, 80.0);
    return physics::break_shot(table, speed * physics::unit_vector(angle), spin);
}

std::vector<BallStart> scattered(base::Random& random, const model::TableSpec& table,
                                 std::uint64_t kind) {
    const ScatterKind scatter{.balls = 2 + random.below(model::kMaxBalls - 1),
                              .many_move = random.below(2) == 0,
                              .are_unequal = kind == 6 || (kind == 7 && random.below(2) == 0),
                              .many_fly = kind == 7};
    return physics::Scatter(random, table).balls(scatter);
}

Case case_of(std::uint64_t number) {
    base::Random random(number);
    const std::uint64_t kind = number % kKinds;
    const auto& table = model::table_of(static_cast<model::TableSize>(random.below(3)));
    Case made{table, {}, {}};
    // Nothing flies in the original design.
    const bool may_be_classic = kind == 5 || kind == 6;
    if (may_be_classic && random.below(4) == 0) made.parameters = physics::classic_parameters();
    if (kind >= 5 && random.below(4) == 0) {
        made.parameters.ball_ball = physics::BallBallModel::Elastic;
    }
    made.balls = kind < 5 ? hard_break(random, table) : scattered(random, table, kind);
    return made;
}

std::size_t percentile(std::vector<std::size_t>& values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

bool prove_breaks(const BreaksOrder& order, std::ostream& out) {
    std::vector<std::size_t> events;
    base::Hasher digest;
    physics::Diagnostics worst{.min_gap_m = 0.0};
    std::uint64_t faults = 0;
    for (std::uint64_t number = order.first; number < order.first + order.shots; ++number) {
        const Case made = case_of(number);
        physics::Diagnostics diagnostics;
        const auto record =
            physics::simulate(made.table, made.parameters, made.balls, &diagnostics);
        const std::optional<std::string> fault =
            record.ok() ? physics::first_fault(
                              {made.table, made.parameters, made.balls, *record, diagnostics})
                        : record.error().detail;
        if (fault) {
            ++faults;
            out << "shot " << number << ": " << *fault << '\n';
            continue;
        }
        digest.add(record->hash);
        events.push_back(record->events.size());
        worst.max_energy_rise_j = std::max(worst.max_energy_rise_j, diagnostics.max_energy_rise_j);
        worst.min_gap_m = std::min(worst.min_gap_m, diagnostics.min_gap_m);
    }
    out << order.shots << " shots, " << faults << " faults";
    if (!events.empty()) {
        out << "; events p50 " << percentile(events, 0.5) << ", p99 " << percentile(events, 0.99)
            << ", most " << events.back() << "; largest energy rise " << worst.max_energy_rise_j
            << " J, smallest gap " << *worst.min_gap_m << " m; digest " << std::hex
            << std::setfill('0') << std::setw(16) << digest.digest() << std::dec;
    }
    out << '\n';
    return faults == 0;
}

}  // namespace billiards
