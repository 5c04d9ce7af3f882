// Takes whose absence counts and from when; gives when each seat's grace is used up.
#pragma once

#include "common/base/time.h"
#include "common/model/seat.h"

#include <optional>

namespace billiards::server {

/// Each seat has so much time to be away. It runs only while it counts, which is for the table to
/// say, and what is spent of it stays spent until it is given back.
class Absence {
  public:
    explicit Absence(base::Duration grace);

    /// From now on this seat's absence counts, or no longer.
    void count(base::Instant now, model::Seat seat, bool counts);
    /// The whole grace again; it goes on running where it counts.
    void give_back(base::Instant now, model::Seat seat);

    /// When the grace is used up, if nothing changes; in the past where it is already. None while
    /// the absence does not count.
    std::optional<base::Instant> ends(model::Seat seat) const { return seats_[seat].ends; }
    bool is_used_up(base::Instant now, model::Seat seat) const;

  private:
    struct Grace {
        base::Duration left{};                ///< While it does not count.
        std::optional<base::Instant> ends{};  ///< While it does.
    };

    base::Duration grace_;
    model::PerSeat<Grace> seats_;
};

}  // namespace billiards::server
