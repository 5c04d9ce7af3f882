// Takes an order of balls; gives the layout before a break.
#include "common/rules/racking.h"

#include "common/base/check.h"

#include <algorithm>
#include <utility>

namespace billiards::rules {

void shuffle(std::span<model::BallId> balls, base::Random& random) {
    for (std::size_t left = balls.size(); left > 1; --left) {
        std::swap(balls[left - 1], balls[random.below(left)]);
    }
}

std::vector<model::BallId> shuffled_balls(int count, base::Random& random) {
    std::vector<model::BallId> balls;
    for (int number = 1; number <= count; ++number) {
        balls.push_back({static_cast<std::uint8_t>(number)});
    }
    shuffle(balls, random);
    return balls;
}

void put_at(std::span<model::BallId> balls, std::size_t place, model::BallId ball) {
    const auto found = std::ranges::find(balls, ball);
    CHECK(found != balls.end() && place < balls.size());
    std::swap(*found, balls[place]);
}

model::Layout racked_layout(std::span<const model::BallId> balls,
                            std::span<const base::Vec2> positions_m) {
    CHECK(balls.size() == positions_m.size());
    model::Layout layout;
    layout.balls.push_back({model::kCueBall, model::Place::InHand, {}});
    for (std::size_t i = 0; i < balls.size(); ++i) {
        layout.balls.push_back({balls[i], model::Place::OnTable, positions_m[i]});
    }
    std::sort(layout.balls.begin(), layout.balls.end(),
              [](const auto& a, const auto& b) { return a.ball < b.ball; });
    return layout;
}

}  // namespace billiards::rules
