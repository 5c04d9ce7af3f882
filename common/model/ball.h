// Gives what a ball is and how it can be moving: the words every other room uses.
#pragma once

#include "common/base/check.h"
#include "common/base/vec.h"

#include <bit>
#include <cstdint>
#include <initializer_list>

namespace billiards::model {

/// A ball's number: 0 is the cue ball, 1 to 15 are the object balls of a set.
struct BallId {
    std::uint8_t number = 0;

    friend auto operator<=>(BallId, BallId) = default;
};

inline constexpr BallId kCueBall{0};
inline constexpr BallId kEightBall{8};
/// The most balls that one table holds at once; ids are below this.
inline constexpr int kMaxBalls = 22;

/// A set of balls, ordered by number.
class BallSet {
  public:
    BallSet() = default;
    BallSet(std::initializer_list<BallId> balls) {
        for (const BallId ball : balls) insert(ball);
    }

    void insert(BallId ball) { bits_ |= bit(ball); }
    void erase(BallId ball) { bits_ &= ~bit(ball); }
    bool contains(BallId ball) const { return (bits_ & bit(ball)) != 0; }
    bool empty() const { return bits_ == 0; }
    int size() const { return std::popcount(bits_); }

    /// Calls visit(BallId) for each ball in ascending number.
    template <class Visit>
    void for_each(Visit visit) const {
        for (std::uint8_t number = 0; number < kMaxBalls; ++number) {
            if (contains(BallId{number})) visit(BallId{number});
        }
    }

    friend BallSet operator&(BallSet a, BallSet b) { return BallSet(a.bits_ & b.bits_); }
    friend BallSet operator|(BallSet a, BallSet b) { return BallSet(a.bits_ | b.bits_); }
    friend BallSet operator-(BallSet a, BallSet b) { return BallSet(a.bits_ & ~b.bits_); }
    friend bool operator==(BallSet, BallSet) = default;

    /// Bit n stands for ball n; bits at and above kMaxBalls are dropped.
    static BallSet from_bits(std::uint32_t bits) { return BallSet(bits & kAllBits); }
    std::uint32_t bits() const { return bits_; }

  private:
    static constexpr std::uint32_t kAllBits = (std::uint32_t{1} << kMaxBalls) - 1;

    explicit BallSet(std::uint32_t bits) : bits_(bits) {}
    static std::uint32_t bit(BallId ball) {
        CHECK(ball.number < kMaxBalls);
        return std::uint32_t{1} << ball.number;
    }

    std::uint32_t bits_ = 0;
};

/// How a ball is moving. The order is part of the wire format; only append.
enum class Motion : std::uint8_t {
    Resting,
    Spinning,  ///< In place, about the vertical axis.
    Rolling,
    Sliding,
    Airborne,
    Pocketed,
    OffTable,
};

inline bool is_on_table(Motion motion) {
    return motion != Motion::Pocketed && motion != Motion::OffTable;
}

struct BallSpec {
    double radius_m = 0.028575;  ///< 2.25 in across: WPA Equipment Specifications, 16.
    double mass_kg = 0.170097;   ///< 6 oz: the same paragraph allows 5.5 - 6 oz.

    friend bool operator==(const BallSpec&, const BallSpec&) = default;
};

/// One ball at one moment. Positions are of its centre: at rest on the cloth z = radius.
struct BallState {
    base::Vec3 position_m{};
    base::Vec3 velocity_mps{};
    base::Vec3 spin_radps{};
    Motion motion = Motion::Resting;

    friend bool operator==(const BallState&, const BallState&) = default;
};

}  // namespace billiards::model
