// Takes a ball that drives into a cushion's nose; gives its change, by the model that is asked for.
#include "common/physics/collide_cushion.h"

#include "common/physics/cushion_mathavan.h"
#include "common/physics/cushion_stronge.h"
#include "common/physics/motion.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec3;

double lean_cosine(const NoseContact& contact) {
    return std::sqrt(std::max(0.0, 1.0 - contact.lean_sine * contact.lean_sine));
}

/// Han, "Dynamics in carom and three cushion billiards", J. Mech. Sci. Tech. 19 (2005). In the
/// frame X into the cushion, Y along it, Z up, with the contact point leant by theta above the
/// centre:
///   s_x = v_x sin - v_z cos + R w_y,  s_y = -v_y - R w_z cos + R w_x sin   (slip)
///   P_z = (1 + e) m c,   c = closing speed along the leaning normal (v_x cos on the slate)
///   (P_x, P_y) = (2/7) m s where that is within the friction mu P_z, else mu P_z s / |s|
///   dv = (-P_x sin - P_z cos, P_y, P_x cos - P_z sin) / m
///   dw = (R / I) (-P_y sin, -P_x, P_y cos)
/// For a ball on the slate v_z = 0, and the slate takes the vertical part of dv.
Kick han_kick(const Parameters& parameters, const Body& ball, const NoseContact& contact) {
    const Vec3 x{contact.into.x, contact.into.y, 0.0};
    const Vec3 y = quarter_turn(x);
    const Vec3 z{0.0, 0.0, 1.0};
    const Vec3& v = ball.state.velocity_mps;
    const Vec3& w = ball.state.spin_radps;
    const double radius = ball.spec.radius_m;
    const double sine = contact.lean_sine;
    const double cosine = lean_cosine(contact);
    const double closing = ball.is_on_slate ? contact.closing_mps * cosine : contact.closing_mps;

    const double slip_x = glm::dot(v, x) * sine - v.z * cosine + radius * glm::dot(w, y);
    const double slip_y = -glm::dot(v, y) - radius * w.z * cosine + radius * glm::dot(w, x) * sine;
    const double slip = std::sqrt(slip_x * slip_x + slip_y * slip_y);
    const double normal = (1.0 + parameters.cushion_restitution) * closing;
    const double grip = std::min(2.0 / 7.0 * slip, parameters.cushion_friction * normal);
    const double p_x = slip > 0.0 ? grip * slip_x / slip : 0.0;
    const double p_y = slip > 0.0 ? grip * slip_y / slip : 0.0;

    const Vec3 change =
        (-p_x * sine - normal * cosine) * x + p_y * y + (p_x * cosine - normal * sine) * z;
    return {
        .velocity_mps = as_free(ball, change),
        .spin_radps = (-p_y * sine * x - p_x * y + p_y * cosine * z) / (kInertiaRatio * radius)};
}

/// Reflect, then scale the speed (the original design, 2.4.2 and equation 9).
Kick mirror_kick(const Parameters& parameters, const Body& ball, const NoseContact& contact) {
    const Vec3& v = ball.state.velocity_mps;
    const Vec3 normal = nose_normal(contact, ball.is_on_slate);
    const Vec3 reflected = v - 2.0 * contact.closing_mps * normal;
    return {.velocity_mps = parameters.cushion_restitution * reflected - v, .spin_radps = {}};
}

}  // namespace

Vec3 nose_normal(const NoseContact& contact, bool is_on_slate) {
    if (is_on_slate) return {contact.into.x, contact.into.y, 0.0};
    const double cosine = lean_cosine(contact);
    return {contact.into.x * cosine, contact.into.y * cosine, contact.lean_sine};
}

Kick cushion_kick(const Parameters& parameters, const Body& ball, const NoseContact& contact) {
    switch (parameters.cushion) {
        case CushionModel::Han2005:
            return han_kick(parameters, ball, contact);
        case CushionModel::Mathavan2010:
            // Without the slate the slip keeps its direction, and the integral is Han's formula.
            return ball.is_on_slate ? mathavan_kick(parameters, ball, contact)
                                    : han_kick(parameters, ball, contact);
        case CushionModel::Stronge:
            return stronge_kick(parameters, ball, contact);
        case CushionModel::Mirror:
            return mirror_kick(parameters, ball, contact);
    }
    return {};
}

}  // namespace billiards::physics
