// Takes balls in a box; gives their motion by small steps.
#include "tests/common/physics/stepped_world.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec3;

constexpr Vec3 kUp{0, 0, 1};

double inertia(const BallStart& ball) {
    return 0.4 * ball.spec.mass_kg * ball.spec.radius_m * ball.spec.radius_m;
}

Vec3 velocity_of_point(const BallStart& ball, const Vec3& arm) {
    return ball.velocity_mps + glm::cross(ball.spin_radps, arm);
}

void push(BallStart& ball, const Vec3& arm, const Vec3& impulse) {
    ball.velocity_mps += impulse / ball.spec.mass_kg;
    ball.spin_radps += glm::cross(arm, impulse) / inertia(ball);
}

bool is_in_air(const BallStart& ball) {
    return ball.position_m.z > ball.spec.radius_m || ball.velocity_mps.z > 0.0;
}

/// What lies on the slate stays there.
void keep_down(BallStart& ball, bool was_in_air) {
    if (!was_in_air) ball.velocity_mps.z = 0.0;
}

Vec3 tangential(const Vec3& v, const Vec3& normal) {
    return v - glm::dot(v, normal) * normal;
}

Vec3 cushion_direction(std::size_t cushion) {
    constexpr std::array<Vec3, 4> kInto{Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, -1, 0},
                                        Vec3{0, 1, 0}};
    return kInto[cushion];
}

bool is_at_rest(const BallStart& ball) {
    return !is_in_air(ball) && ball.velocity_mps == Vec3{} && ball.spin_radps == Vec3{};
}

}  // namespace

SteppedWorld::SteppedWorld(const Parameters& parameters, const SteppedBox& box,
                           const std::vector<BallStart>& balls)
    : parameters_(parameters), box_(box), balls_(balls) {}

void SteppedWorld::run(double dt) {
    while (!std::all_of(balls_.begin(), balls_.end(), is_at_rest)) {
        step(dt);
        now_s_ += dt;
    }
}

/// To the first meeting within the step, found by halving; then on with what is left of it.
void SteppedWorld::step(double dt) {
    double done = 0.0;
    while (true) {
        std::vector<BallStart> then = balls_;
        for (BallStart& ball : then) advance(ball, dt - done);
        SteppedEvent met;
        if (!find_meeting(then, met)) {
            balls_ = std::move(then);
            return;
        }
        double early = 0.0;
        double late = dt - done;
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = (early + late) / 2;
            then = balls_;
            for (BallStart& ball : then) advance(ball, middle);
            (find_meeting(then, met) ? late : early) = middle;
        }
        for (BallStart& ball : balls_) advance(ball, late);
        find_meeting(balls_, met);
        done += late;
        met.time_s = now_s_ + done;
        events_.push_back(met);
        resolve(met);
    }
}

void SteppedWorld::advance(BallStart& ball, double dt) const {
    if (!is_in_air(ball)) return slide_or_roll(ball, dt);
    const Vec3 fall = -parameters_.gravity_mps2 * kUp;
    ball.position_m += dt * (ball.velocity_mps + (dt / 2) * fall);
    ball.velocity_mps += dt * fall;
}

/// Friction at the point that touches the slate, while it slips; then the resistance to rolling.
void SteppedWorld::slide_or_roll(BallStart& ball, double dt) const {
    const Vec3 before = ball.velocity_mps;
    const double g = parameters_.gravity_mps2;
    const Vec3 arm = -ball.spec.radius_m * kUp;
    const Vec3 slip = tangential(velocity_of_point(ball, arm), kUp);
    // The contact point gives way 7/2 times as easily as the centre.
    const double to_stop = 2.0 / 7.0 * ball.spec.mass_kg * glm::length(slip);
    const double sliding = parameters_.sliding_friction * ball.spec.mass_kg * g * dt;
    if (to_stop > 0.0) {
        push(ball, arm, -std::min(to_stop, sliding) / glm::length(slip) * slip);
    }
    if (to_stop <= sliding) {
        const double speed = glm::length(ball.velocity_mps);
        const double slower = std::max(0.0, speed - parameters_.rolling_friction * g * dt);
        ball.velocity_mps = speed > 0.0 ? slower / speed * ball.velocity_mps : Vec3{};
        const Vec3 rolling = glm::cross(kUp, ball.velocity_mps) / ball.spec.radius_m;
        ball.spin_radps = {rolling.x, rolling.y, ball.spin_radps.z};
    }
    const double decay = parameters_.spin_deceleration_radps2 * dt;
    const double spin = std::max(0.0, std::abs(ball.spin_radps.z) - decay);
    ball.spin_radps.z = std::copysign(spin, ball.spin_radps.z);
    if (spin == 0.0) ball.spin_radps.z = 0.0;
    ball.velocity_mps.z = 0.0;
    ball.position_m += (dt / 2) * (before + ball.velocity_mps);
}

bool SteppedWorld::meets(const SteppedEvent& event, const std::vector<BallStart>& balls) const {
    const BallStart& ball = balls[event.ball];
    const Vec3& place = ball.position_m;
    const double radius = ball.spec.radius_m;
    switch (event.kind) {
        case SteppedEvent::Kind::BallBall: {
            const BallStart& other = balls[event.other];
            const Vec3 apart = other.position_m - place;
            return glm::length(apart) < radius + other.spec.radius_m &&
                   glm::dot(apart, other.velocity_mps - ball.velocity_mps) < 0.0;
        }
        case SteppedEvent::Kind::Cushion: {
            const Vec3 into = cushion_direction(event.other);
            const Vec3 half{box_.half_m.x, box_.half_m.y, 0.0};
            return glm::dot(into, place) + radius > glm::dot(glm::abs(into), half) &&
                   glm::dot(into, ball.velocity_mps) > 0.0;
        }
        case SteppedEvent::Kind::Landing:
            return place.z < radius && ball.velocity_mps.z < 0.0;
    }
    return false;
}

bool SteppedWorld::find_meeting(const std::vector<BallStart>& balls, SteppedEvent& event) const {
    using enum SteppedEvent::Kind;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        std::vector<SteppedEvent> candidates{{.kind = Landing, .ball = i}};
        for (std::size_t c = 0; c < 4; ++c)
            candidates.push_back({.kind = Cushion, .ball = i, .other = c});
        for (std::size_t j = i + 1; j < balls.size(); ++j) {
            candidates.push_back({.kind = BallBall, .ball = i, .other = j});
        }
        for (const SteppedEvent& candidate : candidates) {
            if (!meets(candidate, balls)) continue;
            event = candidate;
            return true;
        }
    }
    return false;
}

void SteppedWorld::resolve(const SteppedEvent& event) {
    BallStart& ball = balls_[event.ball];
    switch (event.kind) {
        case SteppedEvent::Kind::BallBall:
            return hit_ball(ball, balls_[event.other]);
        case SteppedEvent::Kind::Cushion:
            return hit_cushion(ball, cushion_direction(event.other));
        case SteppedEvent::Kind::Landing:
            return hit_slate(ball);
    }
}

/// Newton's restitution along the normal, Coulomb's friction along the slip of the two surfaces.
void SteppedWorld::hit_ball(BallStart& a, BallStart& b) const {
    const bool a_flies = is_in_air(a);
    const bool b_flies = is_in_air(b);
    const Vec3 normal = glm::normalize(b.position_m - a.position_m);
    const Vec3 a_arm = a.spec.radius_m * normal;
    const Vec3 b_arm = -b.spec.radius_m * normal;
    const double reduced = 1.0 / (1.0 / a.spec.mass_kg + 1.0 / b.spec.mass_kg);
    const double closing = glm::dot(a.velocity_mps - b.velocity_mps, normal);
    const Vec3 slip = tangential(velocity_of_point(a, a_arm) - velocity_of_point(b, b_arm), normal);
    const double speed = glm::length(slip);
    const double blow = (1.0 + parameters_.ball_ball_restitution) * reduced * closing;
    const double friction =
        parameters_.ball_friction_base +
        parameters_.ball_friction_scale * std::exp(-parameters_.ball_friction_decay_spm * speed);
    const double rub = std::min(friction * blow, 2.0 / 7.0 * reduced * speed);
    const Vec3 impulse = -blow * normal - (speed > 0.0 ? rub / speed : 0.0) * slip;
    push(a, a_arm, impulse);
    push(b, b_arm, -impulse);
    keep_down(a, a_flies);
    keep_down(b, b_flies);
}

/// Han 2005: the nose touches above the centre of a ball on the slate.
void SteppedWorld::hit_cushion(BallStart& ball, const Vec3& into) const {
    const double sine = box_.nose_height_m / ball.spec.radius_m - 1.0;
    const Vec3 normal = std::sqrt(1.0 - sine * sine) * into + sine * kUp;
    const Vec3 arm = ball.spec.radius_m * normal;
    const Vec3 slip = tangential(velocity_of_point(ball, arm), normal);
    const double speed = glm::length(slip);
    const double mass = ball.spec.mass_kg;
    const double blow =
        (1.0 + parameters_.cushion_restitution) * mass * glm::dot(ball.velocity_mps, normal);
    const double rub = std::min(parameters_.cushion_friction * blow, 2.0 / 7.0 * mass * speed);
    push(ball, arm, -blow * normal - (speed > 0.0 ? rub / speed : 0.0) * slip);
    keep_down(ball, false);
}

void SteppedWorld::hit_slate(BallStart& ball) const {
    constexpr double kLeastRebound_mps = 0.05;
    const double fall = -ball.velocity_mps.z;
    double rebound = parameters_.ball_table_restitution * fall;
    if (rebound < kLeastRebound_mps) rebound = 0.0;
    const double mass = ball.spec.mass_kg;
    const Vec3 arm = -ball.spec.radius_m * kUp;
    const Vec3 slip = tangential(velocity_of_point(ball, arm), kUp);
    const double speed = glm::length(slip);
    const double rub =
        std::min(parameters_.sliding_friction * mass * (fall + rebound), 2.0 / 7.0 * mass * speed);
    push(ball, arm, mass * (fall + rebound) * kUp - (speed > 0.0 ? rub / speed : 0.0) * slip);
    ball.velocity_mps.z = rebound;
    ball.position_m.z = ball.spec.radius_m;
}

}  // namespace billiards::physics
