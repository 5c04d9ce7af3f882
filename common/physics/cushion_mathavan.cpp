// Takes a ball on the slate that drives into a nose; gives its change, integrated over the impulse.
#include "common/physics/cushion_mathavan.h"

#include "common/physics/cushion_friction.h"
#include "common/physics/motion.h"

#include <algorithm>
#include <cmath>

namespace billiards::physics {

namespace {

using base::Vec2;
using base::Vec3;

double length_of(const Vec2& v) {
    return std::sqrt(glm::dot(v, v));
}

/// Impulses over the ball's mass since the impact began, or how they grow with the normal one.
struct Passed {
    double normal = 0.0;
    AtBoth friction;
    double work = 0.0;  ///< That the nose took, over mass.
};

Passed operator+(const Passed& a, const Passed& b) {
    return {a.normal + b.normal,
            {a.friction.nose + b.friction.nose, a.friction.slate + b.friction.slate},
            a.work + b.work};
}

Passed operator*(double factor, const Passed& p) {
    return {
        factor * p.normal, {factor * p.friction.nose, factor * p.friction.slate}, factor * p.work};
}

/// How far friction disagrees between two ways to the same normal impulse.
double difference(const Passed& a, const Passed& b) {
    return length_of(a.friction.nose - b.friction.nose) +
           length_of(a.friction.slate - b.friction.slate);
}

/// Slower than this, by the speed of everything, is at rest.
constexpr double kStill = 1e-10;
/// Slower than this, by the same, a contact point may creep.
constexpr double kCreeping = 1e-6;

/// What still has to fall to 0 until a phase ends, and how fast it does by normal impulse.
struct Left {
    double value = 0.0;
    double slope = 0.0;
};

/// One impact of a ball of mass 1: velocities follow from the impulses linearly.
class Impact {
  public:
    /// closing_mps along the leaning normal.
    Impact(const CushionFriction& law, double closing_mps, const AtBoth& slip)
        : law_(law),
          closing_mps_(closing_mps),
          slip_(slip),
          scale_mps_(closing_mps + length_of(slip.nose) + length_of(slip.slate)),
          step_(closing_mps / 4.0) {
        look_what_holds({});
    }

    /// Until the ball has stopped; then until the nose gave back e^2 of the work. False where the
    /// ball wedges.
    bool solve(double e, Passed& passed) {
        const auto until_stopped = [&](const Passed& p) {
            const Passed now = rate(p);
            return Left{closing_mps(p), law_.closing_change(now.friction, now.normal)};
        };
        if (!advance(passed, until_stopped)) return false;
        const double kept = (1.0 - e * e) * passed.work;
        return advance(passed, [&](const Passed& p) {
            return Left{p.work - kept, closing_mps(p)};
        });
    }

  private:
    AtBoth slip(const Passed& p) const {
        const AtBoth change = law_.slip_change(p.friction, p.normal);
        return {slip_.nose + change.nose, slip_.slate + change.slate};
    }
    double closing_mps(const Passed& p) const {
        return closing_mps_ + law_.closing_change(p.friction, p.normal);
    }
    Passed rate(const Passed& p) const {
        return {1.0, law_.friction(slip(p), grips_), closing_mps(p)};
    }

    /// The classical method of Runge and Kutta.
    Passed stepped(const Passed& p, double step) const {
        const Passed a = rate(p);
        const Passed b = rate(p + step / 2.0 * a);
        const Passed c = rate(p + step / 2.0 * b);
        const Passed d = rate(p + step * c);
        return p + step / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    Passed stepped_twice(const Passed& p, double step) const {
        return stepped(stepped(p, step / 2.0), step / 2.0);
    }

    /// Of one contact point: its slip, its grip until now, and the friction that creeping would
    /// have.
    Grip grip_of(const Vec2& slip, Grip before, const Vec2& creeping) const {
        constexpr double kAligned = 1e-4;
        const double speed = length_of(slip);
        if (speed <= kStill * scale_mps_) return Grip::Holds;
        if (speed > kCreeping * scale_mps_) return Grip::Slips;
        if (before != Grip::Slips) return Grip::Creeps;
        const Vec2 turned = creeping / length_of(creeping) + slip / speed;
        return length_of(turned) <= kAligned ? Grip::Creeps : Grip::Slips;
    }

    void look_what_holds(const Passed& p) {
        const AtBoth now = slip(p);
        const AtBoth creeping_nose = law_.friction(now, {Grip::Creeps, grips_.slate});
        const AtBoth creeping_slate = law_.friction(now, {grips_.nose, Grip::Creeps});
        grips_ = {.nose = grip_of(now.nose, grips_.nose, creeping_nose.nose),
                  .slate = grip_of(now.slate, grips_.slate, creeping_slate.slate)};
    }

    /// A slip that ends: most of the way to there if it goes on as now, because friction turns over
    /// beyond. One that creeps away: no further than to where it slips.
    void bound_step(const Vec2& slip, const Vec2& change, Grip grip) {
        const double falling = -glm::dot(slip, change);
        const bool ends = grip != Grip::Holds && falling > 0.0;
        if (ends) step_ = std::min(step_, 0.99 * glm::dot(slip, slip) / falling);
        const double creeping = grip == Grip::Slips ? 0.0 : step_ * length_of(change);
        const double most = kCreeping * scale_mps_;
        if (creeping > most) step_ *= most / creeping;
    }

    void bound_step(const Passed& p) {
        const Passed now = rate(p);
        const AtBoth change = law_.slip_change(now.friction, now.normal);
        bound_step(slip(p).nose, change.nose, grips_.nose);
        bound_step(slip(p).slate, change.slate, grips_.slate);
    }

    /// The next step's length over the latest one's. The error, here over what is allowed, goes
    /// with the fifth power of the step; 1 or less is good enough.
    static double stretch(double error) {
        if (error > 1e6) return 1.0 / 16.0;
        if (!(error <= 1.0)) return 0.5;
        if (error < 1e-7) return 16.0;
        return error < 1.0 / 64.0 ? 2.0 : 1.0;
    }

    /// Steps until nothing is left, each so short that two halves of it agree with the whole.
    template <class LeftAt>
    bool advance(Passed& p, LeftAt left_at) {
        constexpr int kMostSteps = 4'000;
        constexpr double kTolerance = 1e-11;
        constexpr double kWedged = 1e3;  // No impact that ends takes so much more than a mirror's.
        for (int steps = 0; steps < kMostSteps; ++steps) {
            if (left_at(p).value <= 0.0) return true;
            if (p.normal > kWedged * closing_mps_) return false;
            bound_step(p);
            const Passed next = stepped_twice(p, step_);
            const double error = difference(stepped(p, step_), next) / (kTolerance * scale_mps_);
            const double next_step = std::min(stretch(error) * step_, closing_mps_);
            if (error <= 1.0) {
                const bool ends = left_at(next).value <= 0.0;
                p = ends ? stepped_to_end(p, left_at) : next;
                look_what_holds(p);
                if (ends) return true;
            }
            step_ = next_step;
        }
        return false;
    }

    /// The step that ends the phase: Newton's method, with the ends of the step as its bounds.
    template <class LeftAt>
    Passed stepped_to_end(const Passed& p, LeftAt left_at) const {
        double low = 0.0;
        double high = step_;
        double step = step_;
        Passed end = stepped_twice(p, step);
        for (int i = 0; i < 60 && low < high; ++i) {
            const Left left = left_at(end);
            (left.value > 0.0 ? low : high) = step;
            const double newton = step - left.value / left.slope;
            if (std::abs(newton - step) <= 1e-16 * step_) break;
            step = newton > low && newton < high ? newton : (low + high) / 2.0;
            end = stepped_twice(p, step);
        }
        return end;
    }

    const CushionFriction& law_;
    double closing_mps_;
    AtBoth slip_;
    double scale_mps_;
    double step_;
    Grips grips_;
};

}  // namespace

Kick mathavan_kick(const Parameters& parameters, const Body& ball, const NoseContact& contact) {
    const Vec3 x{contact.into.x, contact.into.y, 0.0};
    const Vec3 y = quarter_turn(x);
    const Vec3 n = nose_normal(contact, false);
    const double sine = contact.lean_sine;
    const double cosine = glm::dot(n, x);
    const double radius = ball.spec.radius_m;
    const Vec3& v = ball.state.velocity_mps;
    const Vec3 rim = radius * glm::cross(ball.state.spin_radps, n);
    const Vec3 at_slate = slip_mps(ball.state, radius);

    const CushionFriction law(parameters.cushion_friction, parameters.sliding_friction, sine,
                              cosine);
    const AtBoth slip{
        .nose = {glm::dot(v + rim, y), -glm::dot(v + rim, x) * sine + (v.z + rim.z) * cosine},
        .slate = {glm::dot(at_slate, x), glm::dot(at_slate, y)}};
    const double e = parameters.cushion_restitution;
    Passed p;
    if (!Impact(law, contact.closing_mps * cosine, slip).solve(e, p)) {
        p = {.normal = (1.0 + e) * contact.closing_mps / cosine, .friction = {}};
    }
    const auto& [nose, slate] = p.friction;
    return {
        .velocity_mps = (slate.x - sine * nose.y - cosine * p.normal) * x + (nose.x + slate.y) * y,
        .spin_radps = ((slate.y - sine * nose.x) * x - (slate.x + nose.y) * y +
                       Vec3{0.0, 0.0, cosine * nose.x}) /
                      (kInertiaRatio * radius)};
}

}  // namespace billiards::physics
