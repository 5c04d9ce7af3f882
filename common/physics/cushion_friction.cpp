// Takes slips at nose and slate; gives friction by Coulomb's law at both, coupled by the ball.
#include "common/physics/cushion_friction.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec2;

/// A sphere's contact point takes 7/2 times the speed that its centre takes alone.
constexpr double kGive = 3.5;

double length_of(const Vec2& v) {
    return std::sqrt(glm::dot(v, v));
}

}  // namespace

AtBoth CushionFriction::friction(const AtBoth& slip, const Grips& grips) const {
    AtBoth friction;
    friction.nose = grips.nose == Grip::Slips ? (-most_ / length_of(slip.nose)) * slip.nose
                                              : nose_friction(slip.slate, grips);
    friction.slate = slate_friction(slip.slate, friction.nose, grips.slate);
    return friction;
}

AtBoth CushionFriction::slip_change(const AtBoth& friction, double normal) const {
    const Vec2& nose = friction.nose;
    const Vec2& slate = friction.slate;
    return {.nose = {kGive * nose.x + coupling_along() * slate.y,
                     give_up() * nose.y + coupling_across() * slate.x + sine_ * cosine_ * normal},
            .slate = {kGive * slate.x + coupling_across() * nose.y - cosine_ * normal,
                      kGive * slate.y + coupling_along() * nose.x}};
}

double CushionFriction::closing_change(const AtBoth& friction, double normal) const {
    return cosine_ * (friction.slate.x - sine_ * friction.nose.y - cosine_ * normal);
}

CushionFriction::Yielding CushionFriction::yielding_on_held_slate() const {
    return {.drive = {0.0, (sine_ + coupling_across() / kGive) * cosine_},
            .along = kGive - coupling_along() * coupling_along() / kGive,
            .up = give_up() - coupling_across() * coupling_across() / kGive};
}

/// `grip` = friction at the slate by what presses the ball on it, sin - cos f.y.
CushionFriction::Yielding CushionFriction::yielding_on_slipping_slate(const Vec2& grip) const {
    return {.drive = {coupling_along() * grip.y * sine_,
                      (cosine_ + coupling_across() * grip.x) * sine_},
            .along = kGive,
            .up = give_up() - coupling_across() * grip.x * cosine_,
            .across = -coupling_along() * grip.y * cosine_};
}

/// Friction that holds the nose's contact point; where it creeps or that is too much, friction
/// -most d along the slip's unit vector d for which the slip grows by l d: (most A + l) d = drive.
/// Newton's method for 1 / |d| = 1, which is nearly straight in l.
Vec2 CushionFriction::resisting(const Yielding& yielding, Grip grip) const {
    const double needed_up = -yielding.drive.y / yielding.up;
    const Vec2 needed{-(yielding.drive.x + yielding.across * needed_up) / yielding.along,
                      needed_up};
    if (grip == Grip::Holds && length_of(needed) <= most_) return needed;
    if (most_ == 0.0) return {};
    const double across = most_ * yielding.across;
    double growth = 0.0;
    Vec2 d{};
    for (int i = 0; i < 7; ++i) {
        const double along = most_ * yielding.along + growth;
        const double up = most_ * yielding.up + growth;
        d.y = yielding.drive.y / up;
        d.x = (yielding.drive.x - across * d.y) / along;
        const Vec2 slope{(across * d.y / up - d.x) / along, -d.y / up};
        const double length = length_of(d);
        growth -= (length - 1.0) * length * length / glm::dot(d, slope);
    }
    return (-most_ / length_of(d)) * d;
}

Vec2 CushionFriction::nose_friction(const Vec2& slate_slip, const Grips& grips) const {
    Vec2 against = -slate_slip;
    if (grips.slate != Grip::Slips) {
        const Vec2 nose = resisting(yielding_on_held_slate(), grips.nose);
        against = holding_slate(nose);
        if (length_of(against) <= most_at_slate(nose)) return nose;
    }
    const Vec2 grip = (slate_friction_ / length_of(against)) * against;
    const Vec2 nose = resisting(yielding_on_slipping_slate(grip), grips.nose);
    const bool is_lifted = most_at_slate(nose) == 0.0;
    return is_lifted ? resisting(yielding_on_slipping_slate({}), grips.nose) : nose;
}

/// The slate's contact point answers alike in all directions, so that it creeps along what drives
/// it.
Vec2 CushionFriction::slate_friction(const Vec2& slip, const Vec2& nose, Grip grip) const {
    const double most = most_at_slate(nose);
    const Vec2 against = grip == Grip::Slips ? -slip : holding_slate(nose);
    const double size = length_of(against);
    return grip == Grip::Holds && size <= most ? against : (most / size) * against;
}

/// Friction that would hold the slate's contact point.
Vec2 CushionFriction::holding_slate(const Vec2& nose) const {
    return Vec2{cosine_ - coupling_across() * nose.y, -coupling_along() * nose.x} / kGive;
}

/// By what the nose presses the ball down.
double CushionFriction::most_at_slate(const Vec2& nose) const {
    return slate_friction_ * std::max(0.0, sine_ - cosine_ * nose.y);
}

}  // namespace billiards::physics
