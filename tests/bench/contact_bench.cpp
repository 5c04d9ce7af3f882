// Measures when two balls meet, by kind of question, and what planning a ball takes.
#include "common/base/random.h"
#include "common/physics/detect.h"
#include "common/physics/motion.h"

#include <array>
#include <benchmark/benchmark.h>
#include <cstddef>

namespace billiards::physics {
namespace {

using base::Vec3;

constexpr double kRadius_m = model::BallSpec{}.radius_m;
constexpr double kHorizon_s = 1.0;

/// One centre seen from another, half a metre away.
using Courses = std::array<Course, 64>;

/// Sends them past each other by up to `most_aside_m`, at 1 - 3 m/s.
Courses courses(double most_aside_m, bool same_friction) {
    base::Random random(1);
    Courses made;
    for (Course& course : made) {
        course.position_m = {0.5, random.uniform(-most_aside_m, most_aside_m), 0.0};
        course.velocity_mps = {-random.uniform(1.0, 3.0), 0.0, 0.0};
        if (same_friction) continue;
        course.acceleration_mps2 = {random.uniform(0.0, 0.5), random.uniform(-0.2, 0.2), 0.0};
    }
    return made;
}

void meet(benchmark::State& state, const Courses& all) {
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(meeting_s(all[i++ % all.size()], 2 * kRadius_m, kHorizon_s));
    }
}

/// Friction slows one otherwise than the other, and they meet.
void ContactTimeQuartic(benchmark::State& state) {
    meet(state, courses(kRadius_m, false));
}
BENCHMARK(ContactTimeQuartic);

/// Their accelerations agree, as in flight.
void ContactTimeQuadratic(benchmark::State& state) {
    meet(state, courses(kRadius_m, true));
}
BENCHMARK(ContactTimeQuadratic);

/// They pass by half a metre and more: the hull of the quartic says that the gap stays open.
void ContactTimeDismissed(benchmark::State& state) {
    Courses all = courses(0.5, false);
    for (Course& course : all) course.position_m.y += course.position_m.y < 0 ? -0.5 : 0.5;
    meet(state, all);
}
BENCHMARK(ContactTimeDismissed);

void PlanBall(benchmark::State& state, const model::BallState& start) {
    const Parameters parameters;
    for (auto _ : state) {
        const model::BallState ball = settled(parameters, kRadius_m, start);
        benchmark::DoNotOptimize(plan_motion(parameters, kRadius_m, ball, 0.5));
    }
}
constexpr Vec3 kPlace_m{0.1, 0.2, kRadius_m};
BENCHMARK_CAPTURE(PlanBall, Sliding,
                  model::BallState{.position_m = kPlace_m, .velocity_mps = {2, 1, 0}});
BENCHMARK_CAPTURE(PlanBall, Rolling,
                  model::BallState{.position_m = kPlace_m,
                                   .velocity_mps = {2, 1, 0},
                                   .spin_radps = quarter_turn({2, 1, 0}) / kRadius_m});

}  // namespace
}  // namespace billiards::physics
