// Takes the balls after each event; gives what proofs ask for: energy that rose, gaps that closed
// too far.
#pragma once

#include "common/physics/mover.h"
#include "common/physics/parameters.h"
#include "common/physics/simulate.h"

#include <array>
#include <span>

namespace billiards::physics {

class Watch {
  public:
    Watch(const Parameters& parameters, std::span<const Mover> movers, Diagnostics& diagnostics);

    void look(std::span<const Mover> movers, double now_s);

  private:
    double total_energy_j(std::span<const Mover> movers, double now_s) const;
    void look_at_gaps(std::span<const Mover> movers, double now_s);

    const Parameters& parameters_;
    Diagnostics& diagnostics_;
    double now_s_ = 0.0;
    double energy_j_;  ///< After the latest event.
    double before_j_;  ///< After the last event of the latest earlier instant.
    /// Pairs that overlapped at the start and have not opened yet.
    std::array<std::array<bool, model::kMaxBalls>, model::kMaxBalls> is_exempt_{};
};

}  // namespace billiards::physics
