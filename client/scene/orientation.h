// Takes a shot's timeline; gives how each ball is turned, so that balls are seen to roll. For the
// eye only: the truth knows spins, not orientations.
#pragma once

#include "common/model/ball.h"
#include "common/timeline/timeline.h"

#include <array>
#include <glm/gtc/quaternion.hpp>

namespace billiards::client {

/// `from` turned by a spin for a while.
glm::dquat turned(const glm::dquat& from, const base::Vec3& spin_radps, double duration_s);

/// The balls of a table, from shot to shot. The spin of the timeline is summed in steps of 1/240 s
/// from the strike, so that a time has one orientation however often the screen is drawn.
class Orientations {
  public:
    /// Each ball in a way of its own, the same every time.
    Orientations();

    /// As they are turned now is how the next shot begins.
    void start_shot();
    /// To time_s after the strike of the shot that was started last. Forward costs the time
    /// between; backward, too, is allowed, and costs all from the strike. Below 0 is the strike.
    void advance(const timeline::Timeline& timeline, double time_s);

    /// Of length 1, from the ball's own axes to the table's.
    const glm::dquat& of(model::BallId ball) const { return shown_.at(ball.number); }

  private:
    using Turned = std::array<glm::dquat, model::kMaxBalls>;

    Turned before_shot_;
    Turned on_grid_;  ///< After steps_ whole steps of the shot.
    std::int64_t steps_ = 0;
    Turned shown_;
};

}  // namespace billiards::client
