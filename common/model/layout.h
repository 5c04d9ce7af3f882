// Gives where the balls lie when nothing moves.
#pragma once

#include "common/base/vec.h"
#include "common/model/ball.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace billiards::model {

/// The order is part of the wire format; only append.
enum class Place : std::uint8_t {
    OnTable,
    InHand,    ///< The cue ball, before it is set down; its position means nothing.
    Pocketed,  ///< Keeps the position where it fell.
    OffTable,
};

struct PlacedBall {
    BallId ball;
    Place place = Place::OnTable;
    base::Vec2 position_m{};

    friend bool operator==(const PlacedBall&, const PlacedBall&) = default;
};

/// Every ball of the game once, in ascending number. Balls on the table rest on the slate.
struct Layout {
    std::vector<PlacedBall> balls;

    PlacedBall* find(BallId ball) {
        for (PlacedBall& placed : balls) {
            if (placed.ball == ball) return &placed;
        }
        return nullptr;
    }
    const PlacedBall* find(BallId ball) const { return const_cast<Layout*>(this)->find(ball); }
    bool on_table(BallId ball) const {
        const PlacedBall* placed = find(ball);
        return placed != nullptr && placed->place == Place::OnTable;
    }

    friend bool operator==(const Layout&, const Layout&) = default;
};

}  // namespace billiards::model
