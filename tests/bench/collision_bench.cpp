// Measures single collisions: a ball with a cushion by each model, two balls, and the island of a
// whole rack.
#include "common/model/rack.h"
#include "common/physics/cluster.h"
#include "common/physics/collide_cushion.h"
#include "common/physics/island.h"

#include <benchmark/benchmark.h>
#include <vector>

namespace billiards::physics {
namespace {

constexpr double kRadius_m = model::BallSpec{}.radius_m;

void CushionCollision(benchmark::State& state, CushionModel model) {
    Parameters parameters;
    parameters.cushion = model;
    const Body ball{.spec = {},
                    .state = {.position_m = {0, 0, kRadius_m},
                              .velocity_mps = {2, 1, 0},
                              .spin_radps = {-10, 40, 20}}};
    const NoseContact nose{.into = {1, 0}, .lean_sine = 0.27, .closing_mps = 2.0};
    for (auto _ : state) benchmark::DoNotOptimize(cushion_kick(parameters, ball, nose));
}
BENCHMARK_CAPTURE(CushionCollision, Han2005, CushionModel::Han2005);
BENCHMARK_CAPTURE(CushionCollision, Mathavan2010, CushionModel::Mathavan2010);
BENCHMARK_CAPTURE(CushionCollision, Stronge, CushionModel::Stronge);
BENCHMARK_CAPTURE(CushionCollision, Mirror, CushionModel::Mirror);

/// Touching bodies, solved again and again from the same state.
void Island(benchmark::State& state, const Parameters& parameters, const std::vector<Body>& bodies,
            std::vector<Contact> contacts) {
    IslandSolver solver(parameters);
    std::vector<Body> now;
    for (auto _ : state) {
        now = bodies;
        benchmark::DoNotOptimize(solver.solve(now, contacts, {}, 100));
    }
}

void BallCollision(benchmark::State& state, BallBallModel model) {
    Parameters parameters;
    parameters.ball_ball = model;
    Body struck;
    struck.state.position_m.x = 2 * kRadius_m;
    Body moving;
    moving.state.velocity_mps = {2, 1, 0};
    Island(state, parameters, {moving, struck}, {{.a = 0, .b = 1, .normal = {1, 0, 0}}});
}
BENCHMARK_CAPTURE(BallCollision, Frictional, BallBallModel::Frictional);
BENCHMARK_CAPTURE(BallCollision, Elastic, BallBallModel::Elastic);

Mover mover_at(const Parameters& parameters, base::Vec2 place, base::Vec3 velocity_mps) {
    Mover mover;
    const model::BallState start{.position_m = {place, kRadius_m}, .velocity_mps = velocity_mps};
    mover.plan = plan_motion(parameters, kRadius_m, settled(parameters, kRadius_m, start), 0.0);
    mover.swept.include(place);
    return mover;
}

/// The cue ball at the apex of a frozen rack of fifteen: 31 contacts.
void RackCollision(benchmark::State& state) {
    const Parameters parameters;
    const model::TableSpec& table = model::table_of(model::TableSize::EightFoot);
    const std::vector<base::Vec2> rack = model::triangle_positions(table, kRadius_m);
    const base::Vec2 before_apex = rack.front() - base::Vec2{2 * kRadius_m, 0};
    std::vector<Mover> movers{mover_at(parameters, before_apex, {8, 0, 0})};
    for (const base::Vec2& place : rack) movers.push_back(mover_at(parameters, place, {}));
    Cluster cluster;
    cluster.gather(TableShape(table, kRadius_m), movers, 0, {.cause = Cause::Ball, .index = 1},
                   0.0);
    state.counters["contacts"] = static_cast<double>(cluster.contacts.size());
    Island(state, parameters, cluster.bodies, cluster.contacts);
}
BENCHMARK(RackCollision);

}  // namespace
}  // namespace billiards::physics
