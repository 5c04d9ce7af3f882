// Takes a strike of the cue; gives the ball's motion as the tip leaves it.
#include "common/physics/cue.h"

#include "common/base/elementary.h"

#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec3;

/// The angle alpha by which the ball leaves away from the offset:
/// tan(alpha) = (5/2) a sqrt(1 - a^2) / (1 + m / m_end + (5/2) (1 - a^2)): TP A-31. a = tip offset
/// to the left in radii, m = ball mass, m_end = the cue's effective end mass.
double squirt_rad(const Parameters& parameters, double a) {
    const double depth_squared = 1.0 - a * a;
    return base::arc_tangent(2.5 * a * std::sqrt(depth_squared),
                             1.0 + 1.0 / parameters.cue_end_mass_ratio + 2.5 * depth_squared);
}

}  // namespace

/// V = (1 + m / M) / 2 * k t p / m: k = spring, t = contact time, M = cue mass, m = ball mass.
double cue_speed_mps(const Parameters& parameters, const model::BallSpec& ball, double power) {
    const double ball_speed =
        parameters.cue_spring_npm * parameters.cue_contact_time_s * power / ball.mass_kg;
    return 0.5 * (1.0 + ball.mass_kg / parameters.cue_mass_kg) * ball_speed;
}

/// v = 2 V / (1 + m / M + (5/2) (a^2 + b^2)) along the cue (TP A-30), w = r x m v / I with the tip
/// at r = R (-c d + a l + b n): d = the cue's direction, l = left, n = d's upward perpendicular.
Strike strike(const Parameters& parameters, const model::BallSpec& ball, const model::Shot& shot,
              double cue_speed_mps, bool squirt) {
    const double a = parameters.rolls_at_once ? 0.0 : shot.tip_left;
    const double b = parameters.rolls_at_once ? 0.0 : shot.tip_up;
    const double elevation = parameters.rolls_at_once ? 0.0 : shot.elevation_rad;
    const double cos_angle = base::cosine(shot.angle_rad);
    const double sin_angle = base::sine(shot.angle_rad);
    const double level = base::cosine(elevation);
    const double down = base::sine(elevation);
    const Vec3 d{cos_angle * level, sin_angle * level, -down};
    const Vec3 l{-sin_angle, cos_angle, 0.0};
    const Vec3 n{cos_angle * down, sin_angle * down, level};

    const double speed =
        2.0 * cue_speed_mps / (1.0 + ball.mass_kg / parameters.cue_mass_kg + 2.5 * (a * a + b * b));
    const double heading = shot.angle_rad - (squirt ? squirt_rad(parameters, a) : 0.0);
    const Vec3 leaving{base::cosine(heading) * level, base::sine(heading) * level, -down};
    return {.velocity_mps = speed * leaving,
            .spin_radps = (2.5 * speed / ball.radius_m) * glm::cross(a * l + b * n, d)};
}

}  // namespace billiards::physics
