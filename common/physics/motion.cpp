// Takes a ball's state; gives its motion on cloth and in the air.
#include "common/physics/motion.h"

#include "common/base/check.h"

#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec3;
using model::BallState;
using model::Motion;

double speed_of(const Vec3& v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

/// Friction at the contact point takes 2/7 of the slip from the velocity, and the spin the rest.
void end_slip(BallState& state, double radius_m) {
    state.velocity_mps -= (2.0 / 7.0) * slip_mps(state, radius_m);
    const Vec3 turned = quarter_turn(state.velocity_mps);
    state.spin_radps.x = turned.x / radius_m;
    state.spin_radps.y = turned.y / radius_m;
}

void stop(BallState& state) {
    state.velocity_mps = {};
    state.spin_radps.x = 0.0;
    state.spin_radps.y = 0.0;
    state.motion = state.spin_radps.z != 0.0 ? Motion::Spinning : Motion::Resting;
}

/// Without spin there is no slip: rolling is drawn, gliding is meant.
BallState settled_without_spin(double radius_m, BallState state) {
    state.spin_radps = quarter_turn(state.velocity_mps) / radius_m;
    state.motion = Motion::Rolling;
    if (speed_of(state.velocity_mps) <= kStill_mps) stop(state);
    return state;
}

double spin_decay_radps2(const Parameters& parameters, double vertical_spin_radps) {
    if (vertical_spin_radps == 0.0) return 0.0;
    return vertical_spin_radps > 0.0 ? -parameters.spin_deceleration_radps2
                                     : parameters.spin_deceleration_radps2;
}

double quotient_or_never(double numerator, double denominator) {
    return denominator > 0.0 ? numerator / denominator : kNever_s;
}

/// Sliding: a = -mu g u/|u|, dw/dt = (5 mu g / 2R) (z x u/|u|), until t = 2 |u| / (7 mu g).
/// Mathavan, Jackson, Parkin, "A theoretical analysis of billiard ball dynamics under cushion
/// impacts", 2010; Alciatore TP 4.1. u = slip, mu = sliding friction.
double slide(const Parameters& parameters, double radius_m, timeline::Segment& segment,
             const BallState& state) {
    const Vec3 slip = slip_mps(state, radius_m);
    const double slip_speed = speed_of(slip);
    const Vec3 direction = slip / slip_speed;
    const double deceleration = parameters.sliding_friction * parameters.gravity_mps2;
    segment.acceleration_mps2 = -deceleration * direction;
    segment.spin_rate_radps2 = (2.5 * deceleration / radius_m) * quarter_turn(direction);
    return quotient_or_never(2.0 * slip_speed, 7.0 * deceleration);
}

/// A collision that leaves a ball slower than the stop speed still lets it go for this long: were
/// it to stand at once, a ball that wedges itself between two others could not push them apart.
constexpr double kLastGlide_s = 1e-3;

/// Rolling: a = -mu g v/|v|, w = (z x v) / R, until t = (|v| - stop speed) / (mu g).
double roll(const Parameters& parameters, double radius_m, timeline::Segment& segment,
            const BallState& state) {
    const double speed = speed_of(state.velocity_mps);
    const double deceleration = parameters.rolling_friction * parameters.gravity_mps2;
    segment.acceleration_mps2 = (-deceleration / speed) * state.velocity_mps;
    segment.spin_rate_radps2 = quarter_turn(segment.acceleration_mps2) / radius_m;
    if (speed <= parameters.stop_speed_mps) {
        return std::min(kLastGlide_s, quotient_or_never(speed, deceleration));
    }
    return quotient_or_never(speed - parameters.stop_speed_mps, deceleration);
}

/// Airborne: a = -g z, until z = R: t = (v + sqrt(v^2 + 2 g h)) / g, h the height above the slate.
double fly(const Parameters& parameters, double radius_m, timeline::Segment& segment,
           const BallState& state) {
    const double gravity = parameters.gravity_mps2;
    const double rise = state.velocity_mps.z;
    const double height = std::max(0.0, state.position_m.z - radius_m);
    segment.acceleration_mps2 = {0.0, 0.0, -gravity};
    return quotient_or_never(rise + std::sqrt(rise * rise + 2.0 * gravity * height), gravity);
}

}  // namespace

BallState settled(const Parameters& parameters, double radius_m, BallState state) {
    if (state.position_m.z > radius_m || state.velocity_mps.z > 0.0) {
        state.motion = Motion::Airborne;
        return state;
    }
    state.velocity_mps.z = 0.0;
    if (parameters.rolls_at_once) return settled_without_spin(radius_m, state);
    state.motion = Motion::Sliding;
    if (speed_of(slip_mps(state, radius_m)) <= kStill_mps) {
        end_slip(state, radius_m);
        state.motion = Motion::Rolling;
        if (speed_of(state.velocity_mps) <= kStill_mps) stop(state);
    }
    return state;
}

Plan plan_motion(const Parameters& parameters, double radius_m, const BallState& state,
                 double start_s) {
    Plan plan;
    plan.segment = {.start_s = start_s,
                    .position_m = state.position_m,
                    .velocity_mps = state.velocity_mps,
                    .spin_radps = state.spin_radps,
                    .motion = state.motion};
    double duration = kNever_s;
    if (state.motion == Motion::Sliding) {
        duration = slide(parameters, radius_m, plan.segment, state);
    } else if (state.motion == Motion::Rolling) {
        duration = roll(parameters, radius_m, plan.segment, state);
    } else if (state.motion == Motion::Airborne) {
        duration = fly(parameters, radius_m, plan.segment, state);
    } else if (state.motion == Motion::Spinning) {
        duration =
            quotient_or_never(std::abs(state.spin_radps.z), parameters.spin_deceleration_radps2);
    }
    if (state.motion != Motion::Airborne) {
        plan.segment.spin_rate_radps2.z = spin_decay_radps2(parameters, state.spin_radps.z);
    }
    plan.end_s = start_s + duration;
    return plan;
}

BallState state_at_end(const Parameters& parameters, double radius_m, const Plan& plan) {
    BallState state = state_at(plan.segment, plan.end_s);
    switch (plan.segment.motion) {
        case Motion::Sliding:
            end_slip(state, radius_m);
            state.motion = Motion::Rolling;
            if (speed_of(state.velocity_mps) <= kStill_mps) stop(state);
            return state;
        case Motion::Rolling:
            if (parameters.rolls_at_once) state.spin_radps.z = 0.0;
            stop(state);
            return state;
        case Motion::Spinning:
            state.spin_radps.z = 0.0;
            stop(state);
            return state;
        case Motion::Airborne:
            state.position_m.z = radius_m;
            return state;
        default:
            CHECK(false);
    }
}

double energy_j(const Parameters& parameters, const model::BallSpec& spec, const BallState& state) {
    const double radius = spec.radius_m;
    double twice_kinetic = glm::dot(state.velocity_mps, state.velocity_mps);
    if (!parameters.rolls_at_once) {
        twice_kinetic +=
            kInertiaRatio * radius * radius * glm::dot(state.spin_radps, state.spin_radps);
    }
    const double height = state.position_m.z - radius;
    return spec.mass_kg * (0.5 * twice_kinetic + parameters.gravity_mps2 * height);
}

}  // namespace billiards::physics
