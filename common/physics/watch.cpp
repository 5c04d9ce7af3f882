// Takes the balls after each event; gives the largest rise of energy and the smallest gap.
#include "common/physics/watch.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

double gap_m(const Mover& a, const Mover& b, double now_s) {
    const base::Vec3 offset =
        position_at(b.plan.segment, now_s) - position_at(a.plan.segment, now_s);
    return std::sqrt(glm::dot(offset, offset)) - a.spec.radius_m - b.spec.radius_m;
}

}  // namespace

Watch::Watch(const Parameters& parameters, std::span<const Mover> movers, Diagnostics& diagnostics)
    : parameters_(parameters),
      diagnostics_(diagnostics),
      energy_j_(total_energy_j(movers, 0.0)),
      before_j_(energy_j_) {
    diagnostics_ = {};
    for (std::size_t i = 0; i < movers.size(); ++i) {
        for (std::size_t j = i + 1; j < movers.size(); ++j) {
            is_exempt_[i][j] = gap_m(movers[i], movers[j], 0.0) < -kTouching_m;
        }
    }
    look_at_gaps(movers, 0.0);
}

void Watch::look(std::span<const Mover> movers, double now_s) {
    if (now_s > now_s_) {
        before_j_ = energy_j_;
        now_s_ = now_s;
    }
    energy_j_ = total_energy_j(movers, now_s);
    diagnostics_.max_energy_rise_j =
        std::max(diagnostics_.max_energy_rise_j, energy_j_ - before_j_);
    look_at_gaps(movers, now_s);
}

double Watch::total_energy_j(std::span<const Mover> movers, double now_s) const {
    double total = 0.0;
    for (const Mover& mover : movers) {
        if (!mover.is_in_play()) continue;
        total += energy_j(parameters_, mover.spec, state_at(mover.plan.segment, now_s));
    }
    return total;
}

void Watch::look_at_gaps(std::span<const Mover> movers, double now_s) {
    for (std::size_t i = 0; i < movers.size(); ++i) {
        for (std::size_t j = i + 1; j < movers.size(); ++j) {
            if (!movers[i].is_in_play() || !movers[j].is_in_play()) continue;
            const double gap = gap_m(movers[i], movers[j], now_s);
            if (gap >= 0.0) is_exempt_[i][j] = false;
            if (is_exempt_[i][j]) continue;
            diagnostics_.min_gap_m = std::min(diagnostics_.min_gap_m.value_or(gap), gap);
        }
    }
}

}  // namespace billiards::physics
