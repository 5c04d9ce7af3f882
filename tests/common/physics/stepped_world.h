// Takes balls in a box of cushions; gives their motion by small steps, from forces and impulses:
// written from the physics, with nothing of the engine's formulas but its constants.
#pragma once

#include "common/physics/parameters.h"
#include "common/physics/simulate.h"

#include <cstddef>
#include <vector>

namespace billiards::physics {

/// Four cushions around the origin.
struct SteppedBox {
    base::Vec2 half_m{1.0, 0.5};
    double nose_height_m = 0.0;
};

/// What met: two balls, a ball and a cushion (0 -x, 1 +x, 2 -y, 3 +y), or a ball and the slate.
struct SteppedEvent {
    enum class Kind { BallBall, Cushion, Landing };
    double time_s = 0.0;
    Kind kind = Kind::BallBall;
    std::size_t ball = 0;
    std::size_t other = 0;
};

class SteppedWorld {
  public:
    SteppedWorld(const Parameters& parameters, const SteppedBox& box,
                 const std::vector<BallStart>& balls);

    /// Steps of dt until every ball rests.
    void run(double dt);

    const std::vector<BallStart>& balls() const { return balls_; }
    const std::vector<SteppedEvent>& events() const { return events_; }

  private:
    void step(double dt);
    void advance(BallStart& ball, double dt) const;
    void slide_or_roll(BallStart& ball, double dt) const;
    bool meets(const SteppedEvent& event, const std::vector<BallStart>& balls) const;
    bool find_meeting(const std::vector<BallStart>& balls, SteppedEvent& event) const;
    void resolve(const SteppedEvent& event);
    void hit_ball(BallStart& a, BallStart& b) const;
    void hit_cushion(BallStart& ball, const base::Vec3& into) const;
    void hit_slate(BallStart& ball) const;

    Parameters parameters_;
    SteppedBox box_;
    std::vector<BallStart> balls_;
    std::vector<SteppedEvent> events_;
    double now_s_ = 0.0;
};

}  // namespace billiards::physics
