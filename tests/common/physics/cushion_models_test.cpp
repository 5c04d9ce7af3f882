// Holds what every cushion model must do: alone, and in whole shots.
#include "tests/common/physics/lone_ball.h"

namespace billiards::physics {
namespace {

constexpr CushionModel kModels[] = {CushionModel::Han2005, CushionModel::Mathavan2010,
                                    CushionModel::Stronge, CushionModel::Mirror};

Parameters with_model(CushionModel model) {
    Parameters parameters;
    parameters.cushion = model;
    return parameters;
}

class CushionModels : public testing::TestWithParam<CushionModel> {};

INSTANTIATE_TEST_SUITE_P(Each, CushionModels, testing::ValuesIn(kModels));

TEST_P(CushionModels, AShotGivesWhatTheModelAloneGives) {
    const Parameters parameters = with_model(GetParam());
    model::TableSpec table;
    table.cushions = {{{0.5, -9}, {0.5, 9}}};
    table.nose_height_m = 0.635 * 2 * kRadius_m;
    const Vec3 spin{-20, 60, 40};
    const auto record = solved(table, parameters, {ball_at(1, {0.5 - kRadius_m, 0}, {2, 1}, spin)});
    const Body alone = bounced(parameters, lone_ball({2, 1, 0}, spin), 2 * 0.635 - 1);
    const auto& after = track_of(record, 1).segments.front();
    EXPECT_LT(speed_of(after.velocity_mps - alone.state.velocity_mps), 1e-12);
    EXPECT_LT(speed_of(after.spin_radps - alone.state.spin_radps), 1e-9);
}

TEST_P(CushionModels, ARollingBallComesBackAsFastAsTablesShow) {
    // Ball-cushion restitution is 0.6 - 0.9 (Alciatore, physical properties).
    const Vec2 straight{2, 0};
    const Body after =
        bounced(with_model(GetParam()), lone_ball({straight, 0}, rolling_spin(straight)));
    EXPECT_GT(-after.state.velocity_mps.x / 2, 0.6);
    EXPECT_LT(-after.state.velocity_mps.x / 2, 0.9);
    EXPECT_EQ(after.state.velocity_mps.y, 0.0);
}

TEST_P(CushionModels, WhatDoesNotCloseStaysAsItIs) {
    const Body parting = lone_ball({-1, 1, 0}, {10, 20, 30});
    EXPECT_EQ(bounced(with_model(GetParam()), parting).state, parting.state);
}

TEST_P(CushionModels, EnergyNeverRisesInShotsWithFrozenBalls) {
    base::Random random(11);
    for (int i = 0; i < 20; ++i) {
        Scatter scatter(random, nine_foot());
        Diagnostics diagnostics;
        solved(nine_foot(), with_model(GetParam()), scatter.balls(10, true), &diagnostics);
        EXPECT_LE(diagnostics.max_energy_rise_j, 1e-12);
        EXPECT_GT(diagnostics.min_gap_m.value_or(0.0), -1e-9);
    }
}

TEST_P(CushionModels, AShotTurnedByHalfATurnIsTheSameBitForBit) {
    const std::vector<BallStart> balls{ball_at(0, {0.2, 0.1}, {3, 2}, {20, -30, 60}),
                                       ball_at(1, {0.6, 0.4})};
    std::vector<BallStart> turned = balls;
    for (BallStart& ball : turned) {
        ball.position_m *= Vec3{-1, -1, 1};
        ball.velocity_mps *= Vec3{-1, -1, 1};
        ball.spin_radps *= Vec3{-1, -1, 1};
    }
    const auto one = solved(nine_foot(), with_model(GetParam()), balls);
    const auto other = solved(nine_foot(), with_model(GetParam()), turned);
    EXPECT_FALSE(events_of(one, EventKind::Cushion).empty());
    EXPECT_EQ(one.duration_s, other.duration_s);
    for (std::size_t i = 0; i < one.final_layout.balls.size(); ++i) {
        EXPECT_EQ(one.final_layout.balls[i].position_m, -other.final_layout.balls[i].position_m);
    }
}

}  // namespace
}  // namespace billiards::physics
