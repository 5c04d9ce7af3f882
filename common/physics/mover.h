// Gives a ball as the engine keeps it: its plan, and what will happen to it if it meets no other.
#pragma once

#include "common/model/ball.h"
#include "common/physics/detect.h"
#include "common/physics/motion.h"
#include "common/physics/table_shape.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace billiards::physics {

/// What a ball comes to.
enum class Cause : std::uint8_t { MotionEnd, Ball, Wall, Post, Pocket, Edge };

struct Next {
    double time_s = kNever_s;
    Cause cause = Cause::MotionEnd;
    int index = 0;  ///< Of the other ball, wall, post or pocket.
};

/// The cushions and jaws that a ball has touched and not left, in the numbering of `Fixed`.
class Leanings {
  public:
    bool contains(std::uint16_t fixed) const { return std::find(begin(), end(), fixed) != end(); }
    /// A ball that leans on more than it has room for forgets the new one.
    void add(std::uint16_t fixed) {
        if (!contains(fixed) && count_ < fixed_.size()) fixed_[count_++] = fixed;
    }
    template <class Condition>
    void remove_if(Condition condition) {
        const auto last = std::remove_if(fixed_.begin(), fixed_.begin() + count_, condition);
        count_ = static_cast<std::uint8_t>(last - fixed_.begin());
    }
    const std::uint16_t* begin() const { return fixed_.data(); }
    const std::uint16_t* end() const { return fixed_.data() + count_; }

  private:
    std::array<std::uint16_t, 6> fixed_{};
    std::uint8_t count_ = 0;
};

struct Mover {
    model::BallId id;
    model::BallSpec spec;
    Plan plan;
    Next alone;  ///< What happens first where no other ball interferes.
    Box swept;   ///< Holds the centre from the planning until alone.time_s.
    Leanings leanings;

    bool is_in_play() const { return model::is_on_table(plan.segment.motion); }
};

/// The same motion counted from now_s.
inline Course course_at(const timeline::Segment& segment, double now_s) {
    return {.position_m = position_at(segment, now_s),
            .velocity_mps = velocity_at(segment, now_s),
            .acceleration_mps2 = segment.acceleration_mps2};
}

}  // namespace billiards::physics
