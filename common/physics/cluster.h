// Takes the balls at one instant and two bodies that meet; gives everything that hangs together
// with them by touching.
#pragma once

#include "common/physics/island.h"
#include "common/physics/mover.h"
#include "common/physics/nearness.h"
#include "common/physics/table_shape.h"

#include <span>
#include <vector>

namespace billiards::physics {

/// Bodies that touch, and where. Keeps its memory from one gathering to the next.
class Cluster {
  public:
    /// Gathers around one mover and what it meets: `met` is of cause Ball, Wall or Post. That
    /// contact is contacts[0].
    void gather(const TableShape& shape, std::span<const Mover> movers, int mover, const Next& met,
                double now_s);

    std::vector<int> members;  ///< Index of the mover behind each body.
    std::vector<Body> bodies;
    std::vector<Contact> contacts;

  private:
    int body_of(std::span<const Mover> movers, int mover, double now_s);
    bool is_stopped_towards(int body, const base::Vec2& into) const;
    void add_pair(int a, int b);
    void add_fixed(const TableShape& shape, int body, FixedIndex fixed);
    void look_for_balls(std::span<const Mover> movers, int body, double now_s);
    void look_for_fixed(const TableShape& shape, int body);

    std::vector<FixedIndex> touching_;
};

}  // namespace billiards::physics
