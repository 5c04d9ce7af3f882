// Takes a call and the facts of its shot; gives whether it may be said, and whether it was made.
#include "common/rules/called_shot.h"

#include <algorithm>

namespace billiards::rules {

bool is_shot_call(model::BallSet balls, const model::Call& call) {
    if (std::holds_alternative<model::Safety>(call)) return true;
    const auto* called = std::get_if<model::CalledBall>(&call);
    return called != nullptr && called->pocket.number < model::kPockets &&
           called->ball.number < model::kMaxBalls && balls.contains(called->ball);
}

std::optional<model::BallId> called_ball_down(model::BallSet balls, const model::Call& call,
                                              const Facts& facts) {
    const auto* called = std::get_if<model::CalledBall>(&call);
    if (called == nullptr || !is_shot_call(balls, call)) return std::nullopt;
    const PocketedBall wanted{called->ball, called->pocket};
    const bool down = std::ranges::find(facts.pocketed, wanted) != facts.pocketed.end();
    return down ? std::optional(called->ball) : std::nullopt;
}

}  // namespace billiards::rules
