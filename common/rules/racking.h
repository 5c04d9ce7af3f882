// Takes an order of object balls and their places; gives the layout before a break.
#pragma once

#include "common/base/random.h"
#include "common/base/vec.h"
#include "common/model/ball.h"
#include "common/model/layout.h"

#include <span>
#include <vector>

namespace billiards::rules {

/// Every order is as likely as any other (Fisher and Yates; TAOCP 2, 3.4.2, algorithm P).
void shuffle(std::span<model::BallId> balls, base::Random& random);

/// Balls 1 to `count`, in random order.
std::vector<model::BallId> shuffled_balls(int count, base::Random& random);

/// Puts a ball of `balls` where it belongs, in exchange with the one that is there.
void put_at(std::span<model::BallId> balls, std::size_t place, model::BallId ball);

/// balls[i] at positions_m[i], and the cue ball in hand. There are as many balls as positions.
model::Layout racked_layout(std::span<const model::BallId> balls,
                            std::span<const base::Vec2> positions_m);

}  // namespace billiards::rules
