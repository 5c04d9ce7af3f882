// Takes balls that were planned anew; gives the next event of all.
#pragma once

#include "common/model/ball.h"
#include "common/physics/forecast.h"
#include "common/physics/mover.h"

#include <array>
#include <cstddef>
#include <span>

namespace billiards::physics {

/// Holds when each two balls meet, and each ball's first event. Only balls that an event touched
/// are looked at again.
class Agenda {
  public:
    struct Entry {
        int ball = 0;
        Next next;
    };

    /// Looks at these balls anew; every mover's `alone` is up to date.
    void update(std::span<const Mover> movers, std::span<const int> changed, double now_s);

    /// The first event; at the same instant motion changes come before contacts. time_s is
    /// kNever_s when nothing moves any more.
    Entry first(std::span<const Mover> movers) const;

  private:
    double meet(std::span<const Mover> movers, int ball, int other, double now_s);
    void choose(std::span<const Mover> movers, int ball);

    template <class T>
    using PerBall = std::array<T, model::kMaxBalls>;

    PerBall<PerBall<double>> meetings_s_{};
    PerBall<Next> next_{};
};

}  // namespace billiards::physics
