// Takes a ball that drives into a springy nose; gives its change, phase by phase in closed form.
#include "common/physics/cushion_stronge.h"

#include "common/base/elementary.h"
#include "common/physics/motion.h"

#include <algorithm>
#include <cmath>
#include <optional>

// Units of the contact: time 1 / omega_n, omega_n = the frequency along the normal; speed along the
// normal c = the closing speed; across it (7/2) mu c. Then, with the phase p of the normal force
//   normal    f = sin p,  p = time until pi/2 (the way in), then pi/2 + (time - pi/2) / e until pi
//   across    w' = -q: w = slip, q = force against it
//   sticking  q' = W^2 w, W = omega_t / omega_n, until |q| would exceed f
//   slipping  q = +-f, until the contact point no longer outruns its spring: w = q' / W^2

namespace billiards::physics {

namespace {

using base::Vec3;

constexpr double kFrequencyRatio = 1.8;
constexpr double kMostGrip = 1.0 / (kFrequencyRatio * kFrequencyRatio);
constexpr double kTurn = base::kPi / 2;  ///< Phase between the way in and the way out.

double time_at(double phase, double e) {
    return phase <= kTurn ? phase : kTurn + e * (phase - kTurn);
}

/// The integral of f from the start.
double normal_impulse(double phase, double e) {
    return 1.0 - (phase <= kTurn ? 1.0 : e) * base::cosine(phase);
}

double phase_of_cosine(double cosine) {
    return base::arc_tangent(std::sqrt((1.0 - cosine) * (1.0 + cosine)), cosine);
}

/// When the first slip ends: w = f' / W^2 on the way in or out; none where it never does.
std::optional<double> gripping_phase(double slip, double e) {
    if (slip <= kMostGrip) return 0.0;
    if (slip <= 1.0) return phase_of_cosine((1.0 - slip) / (1.0 - kMostGrip));
    if (e * kFrequencyRatio <= 1.0) return {};
    const double reach = e - kMostGrip / e;
    if (slip >= 1.0 + reach) return {};
    return phase_of_cosine((1.0 - slip) / reach);
}

struct Across {
    double force = 0.0;
    double slip = 0.0;
};

Across swung(const Across& start, double time) {
    const double cosine = base::cosine(kFrequencyRatio * time);
    const double sine = base::sine(kFrequencyRatio * time);
    return {.force = start.force * cosine + kFrequencyRatio * start.slip * sine,
            .slip = start.slip * cosine - start.force / kFrequencyRatio * sine};
}

/// What the contact takes of a slip >= 0, the integral of q. It may slip, then sticks, and slips
/// once more as the normal force fades; a contact that sticks does not let go on the way in.
double slip_taken(double slip, double e) {
    const std::optional<double> grips = gripping_phase(slip, e);
    if (!grips) return 1.0 + e;
    const Across gripped{.force = base::sine(*grips), .slip = slip - normal_impulse(*grips, e)};
    const auto stuck_at = [&](double phase) {
        return swung(gripped, time_at(phase, e) - time_at(*grips, e));
    };
    double sticks = std::max(*grips, kTurn);
    double slips = base::kPi;
    for (double middle = (sticks + slips) / 2; middle > sticks && middle < slips;
         middle = (sticks + slips) / 2) {
        const bool holds = std::abs(stuck_at(middle).force) <= base::sine(middle);
        (holds ? sticks : slips) = middle;
    }
    const Across let_go = stuck_at(slips);
    const double fading = e * (1.0 + base::cosine(slips));
    return slip - let_go.slip + (let_go.force > 0.0 ? fading : -fading);
}

}  // namespace

Kick stronge_kick(const Parameters& parameters, const Body& ball, const NoseContact& contact) {
    const double e = parameters.cushion_restitution;
    const Vec3 normal = nose_normal(contact, false);
    const Vec3 flat = nose_normal(contact, ball.is_on_slate);
    const double closing = contact.closing_mps * glm::dot(flat, normal);

    const Vec3& v = ball.state.velocity_mps;
    const Vec3 rim = ball.spec.radius_m * glm::cross(ball.state.spin_radps, normal);
    const Vec3 slip = v - glm::dot(v, normal) * normal + rim;
    const double speed = std::sqrt(glm::dot(slip, slip));
    const double unit = parameters.cushion_friction * closing;
    if (speed <= kStill_mps || unit <= 0.0) {
        return {.velocity_mps = as_free(ball, -(1.0 + e) * closing * normal), .spin_radps = {}};
    }
    const Vec3 grip = (unit * slip_taken(speed / (3.5 * unit), e) / speed) * slip;
    return {.velocity_mps = as_free(ball, -(1.0 + e) * closing * normal - grip),
            .spin_radps = glm::cross(grip, normal) / (kInertiaRatio * ball.spec.radius_m)};
}

}  // namespace billiards::physics
