// Takes how a ball slips at a cushion's nose and on the slate while the nose stops it; gives the
// friction at both.
#pragma once

#include "common/base/vec.h"

#include <cstdint>

namespace billiards::physics {

/// Friction, or slip, at the two places. Axes: X into the cushion, Y along it, Z up; the nose
/// touches at n = (cos, 0, sin) from the centre in radii, T = (-sin, 0, cos) is the tangent
/// upwards.
struct AtBoth {
    base::Vec2 nose{};   ///< Along Y and T.
    base::Vec2 slate{};  ///< Along X and Y.
};

enum class Grip : std::uint8_t {
    Slips,   ///< Friction is against the slip.
    Creeps,  ///< So slowly that it slips where friction lets it go on in the same direction.
    Holds,   ///< At rest, where friction can hold it; else it is about to creep.
};

struct Grips {
    Grip nose = Grip::Slips;
    Grip slate = Grip::Slips;
};

/// Coulomb's law at a rigid nose and at the slate, for a sphere of mass 1 that stays on the slate.
/// All impulses and rates are by unit of normal impulse at the nose. A sphere answers an impulse at
/// its surface with 5/2 of it in speed there, besides what its centre takes.
class CushionFriction {
  public:
    CushionFriction(double at_nose, double at_slate, double lean_sine, double lean_cosine)
        : most_(at_nose), slate_friction_(at_slate), sine_(lean_sine), cosine_(lean_cosine) {}

    /// What friction at both places is for these slips.
    AtBoth friction(const AtBoth& slip, const Grips& grips) const;

    /// By how much this friction and normal impulse change the slips, and the speed along n.
    AtBoth slip_change(const AtBoth& friction, double normal) const;
    double closing_change(const AtBoth& friction, double normal) const;

  private:
    /// The slip rate at the nose is drive + (along f.x + across f.y, up f.y) under the friction f.
    struct Yielding {
        base::Vec2 drive{};
        double along = 0.0;
        double up = 0.0;
        double across = 0.0;
    };

    Yielding yielding_on_held_slate() const;
    Yielding yielding_on_slipping_slate(const base::Vec2& grip) const;
    base::Vec2 resisting(const Yielding& yielding, Grip grip) const;
    base::Vec2 nose_friction(const base::Vec2& slate_slip, const Grips& grips) const;
    base::Vec2 slate_friction(const base::Vec2& slip, const base::Vec2& nose, Grip grip) const;
    base::Vec2 holding_slate(const base::Vec2& nose) const;
    double most_at_slate(const base::Vec2& nose) const;
    // What an impulse at one place does to the slip at the other.
    double coupling_along() const { return 1.0 - 2.5 * sine_; }
    double coupling_across() const { return 2.5 - sine_; }
    double give_up() const { return 2.5 + sine_ * sine_; }

    double most_;  ///< Friction at the nose.
    double slate_friction_;
    double sine_;
    double cosine_;
};

}  // namespace billiards::physics
