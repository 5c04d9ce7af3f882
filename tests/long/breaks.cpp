// Takes a number of shots; gives their faults and figures.
#include "tests/long/breaks.h"

#include "common/base/hash.h"
#include "common/base/hex.h"
#include "tests/common/physics/numbered_case.h"
#include "tests/common/physics/soundness.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace billiards {

namespace {

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
        const physics::NumberedCase made = physics::numbered_case(number);
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
            << " J, smallest gap " << *worst.min_gap_m << " m; digest "
            << base::to_hex(digest.digest());
    }
    out << '\n';
    return faults == 0;
}

}  // namespace billiards
