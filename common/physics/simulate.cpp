// Takes a table, balls and a strike; gives the record of what follows.
#include "common/physics/simulate.h"

#include "common/physics/cue.h"
#include "common/physics/shot_solver.h"
#include "common/physics/validate.h"

#include <algorithm>
#include <vector>

namespace billiards::physics {

namespace {

Result<timeline::ShotRecord> solve(const model::TableSpec& table, const Parameters& parameters,
                                   std::vector<BallStart> balls,
                                   std::span<const model::PlacedBall> absent,
                                   Diagnostics* diagnostics) {
    if (auto valid = validate(parameters); !valid) return std::move(valid).error();
    if (auto valid = validate(table); !valid) return std::move(valid).error();
    if (auto valid = validate(table, balls); !valid) return std::move(valid).error();
    std::sort(balls.begin(), balls.end(),
              [](const BallStart& a, const BallStart& b) { return a.ball < b.ball; });
    return ShotSolver(table, parameters, balls, diagnostics).solve(absent);
}

}  // namespace

Result<timeline::ShotRecord> simulate(const model::TableSpec& table, const Parameters& parameters,
                                      std::span<const BallStart> balls, Diagnostics* diagnostics) {
    return solve(table, parameters, {balls.begin(), balls.end()}, {}, diagnostics);
}

Result<timeline::ShotRecord> simulate_shot(const model::TableSpec& table,
                                           const Parameters& parameters,
                                           const model::Layout& layout, const model::Shot& shot) {
    if (auto valid = validate(shot); !valid) return std::move(valid).error();
    if (auto valid = validate(parameters); !valid) return std::move(valid).error();
    if (!layout.on_table(model::kCueBall))
        return Error{ErrorCode::NoCueBall, "no cue ball on the table"};
    std::vector<BallStart> balls;
    std::vector<model::PlacedBall> absent;
    for (const model::PlacedBall& placed : layout.balls) {
        if (placed.place != model::Place::OnTable) {
            absent.push_back(placed);
            continue;
        }
        BallStart& ball = balls.emplace_back(BallStart{.ball = placed.ball});
        ball.position_m = {placed.position_m, ball.spec.radius_m};
        if (placed.ball != model::kCueBall) continue;
        const Strike struck =
            strike(parameters, ball.spec, shot, cue_speed_mps(parameters, ball.spec, shot.power));
        ball.velocity_mps = struck.velocity_mps;
        ball.spin_radps = struck.spin_radps;
    }
    return solve(table, parameters, std::move(balls), absent, nullptr);
}

}  // namespace billiards::physics
