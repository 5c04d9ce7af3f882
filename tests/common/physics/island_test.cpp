// Holds simultaneous and resting contacts against what symmetry, momentum and energy demand.
#include "common/physics/order_free_sum.h"
#include "common/physics/stopping_impulses.h"
#include "tests/common/physics/still_life.h"

#include <array>
#include <numeric>

namespace billiards::physics {
namespace {

Parameters elastic() {
    Parameters parameters;
    parameters.ball_ball = BallBallModel::Elastic;
    return parameters;
}

constexpr double kDiameter_m = 2 * kRadius_m;

TEST(OrderFreeSum, IsTheSameInEveryOrderAndTurnsItsSign) {
    base::Random random(5);
    std::array<double, 7> terms{};
    for (double& term : terms)
        term = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-12, 2));
    const double sum = order_free_sum(terms);
    EXPECT_NEAR(sum, std::accumulate(terms.begin(), terms.end(), 0.0), 1e-13);
    for (int i = 0; i < 100; ++i) {
        std::swap(terms[random.below(7)], terms[random.below(7)]);
        EXPECT_EQ(order_free_sum(terms), sum);
    }
    for (double& term : terms) term = -term;
    EXPECT_EQ(order_free_sum(terms), -sum);
}

TEST(OrderFreeSum, OfNothingIsNothing) {
    EXPECT_EQ(order_free_sum({}), 0.0);
    const std::array zeros{0.0, -0.0};
    EXPECT_EQ(order_free_sum(zeros), 0.0);
}

TEST(StoppingImpulses, StopEveryContactAndPullNowhere) {
    base::Random random(9);
    for (int attempt = 0; attempt < 200; ++attempt) {
        const std::size_t count = 2 + random.below(6);
        const std::size_t rank = 1 + random.below(count + 2);
        std::vector<double> factors(count * rank);
        for (double& factor : factors) factor = random.uniform(-1, 1);
        std::vector<double> mobility(count * count);
        std::vector<double> velocity(rank);
        for (double& part : velocity) part = random.uniform(-1, 1);
        std::vector<double> closing(count);
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < rank; ++k)
                closing[i] += factors[i * rank + k] * velocity[k];
            if (closing[i] < 0) {
                closing[i] = -closing[i];
                for (std::size_t k = 0; k < rank; ++k) factors[i * rank + k] *= -1;
            }
        }
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = 0; j < count; ++j) {
                for (std::size_t k = 0; k < rank; ++k) {
                    mobility[i * count + j] += factors[i * rank + k] * factors[j * rank + k];
                }
            }
        }
        StoppingImpulses solver;
        const auto impulses = solver.solve(closing, mobility);
        for (std::size_t i = 0; i < count; ++i) {
            double left = closing[i];
            for (std::size_t j = 0; j < count; ++j) left -= mobility[i * count + j] * impulses[j];
            EXPECT_GE(impulses[i], 0.0);
            EXPECT_LT(left, 1e-9) << "still closing";
            EXPECT_LT(std::abs(left * impulses[i]), 1e-9) << "pushed though it parts";
        }
    }
}

TEST(Island, TwoFrozenBallsHitAtOnceShareEqually) {
    const double half = kRadius_m;
    const double deep = std::sqrt(3.0) * kRadius_m;
    const auto record = solved(model::open_table(), elastic(),
                               {ball_at(0, {-0.3, 0}, {3, 0}, rolling_spin({3, 0})),
                                ball_at(1, {deep - 0.1, half}), ball_at(2, {deep - 0.1, -half})});
    const double hit_s = events_of(record, EventKind::BallBall).at(0).time_s;
    const Vec3 upper = state_of(record, 1, hit_s).velocity_mps;
    const Vec3 lower = state_of(record, 2, hit_s).velocity_mps;
    EXPECT_EQ(upper.x, lower.x);
    EXPECT_EQ(upper.y, -lower.y);
    EXPECT_EQ(state_of(record, 0, hit_s).velocity_mps.y, 0.0);
    const double speed = state_of(record, 0, std::nextafter(hit_s, 0.0)).velocity_mps.x;
    EXPECT_NEAR(speed_of(upper) / speed, 2 * std::sqrt(3.0) / 5, 1e-9)
        << "6/5 and -1/5, as books say";
    EXPECT_NEAR(state_of(record, 0, hit_s).velocity_mps.x / speed, -0.2, 1e-9);
}

TEST(Island, CradlePassesTheBlowToTheLastBall) {
    for (const int count : {2, 3, 5, 7}) {
        std::vector<BallStart> balls{ball_at(0, {-kDiameter_m, 0}, {2, 0})};
        for (int i = 1; i <= count; ++i) balls.push_back(ball_at(i, {(i - 1) * kDiameter_m, 0}));
        const auto record = solved(model::open_table(), elastic(), balls);
        for (int i = 0; i < count; ++i) {
            EXPECT_NEAR(state_of(record, i, 0.0).velocity_mps.x, 0.0, 1e-12) << i;
        }
        EXPECT_NEAR(state_of(record, count, 0.0).velocity_mps.x, 2.0, 1e-12);
    }
}

TEST(Island, CradleStruckByTwoSendsTwo) {
    std::vector<BallStart> balls;
    for (int i = 0; i < 5; ++i) {
        balls.push_back(ball_at(i, {i * kDiameter_m, 0}, i < 2 ? Vec2{2, 0} : Vec2{0, 0}));
    }
    const auto record = solved(model::open_table(), elastic(), balls);
    for (int i = 0; i < 5; ++i) {
        EXPECT_NEAR(state_of(record, i, 0.0).velocity_mps.x, i < 3 ? 0.0 : 2.0, 1e-12) << i;
    }
}

TEST(Island, FrozenBallsStayPutUntilTheyAreHit) {
    const auto& table = nine_foot();
    std::vector<BallStart> balls = break_shot(table, {0, 0});
    balls.push_back(ball_at(16, {0.3, table.half_playing_m.y - kRadius_m}));
    const auto record = solved(table, {}, balls);
    EXPECT_TRUE(record.events.empty());
    EXPECT_EQ(record.duration_s, 0.0);
    for (const BallStart& ball : balls) {
        EXPECT_EQ(state_of(record, ball.ball.number, 1.0).position_m, ball.position_m);
    }
}

TEST(Island, ABallFrozenToACushionRollsAlongItAsIfAlone) {
    const double y = nine_foot().half_playing_m.y - kRadius_m;
    const auto record =
        solved(nine_foot(), {}, {ball_at(1, {0.2, y}, {0.3, 0}, rolling_spin({0.3, 0}))});
    EXPECT_TRUE(events_of(record, EventKind::Cushion).empty());
    EXPECT_EQ(record.final_layout.balls[0].position_m.y, y);
}

TEST(Island, ABlowThroughAFrozenBallComesBackFromTheCushion) {
    // Cue ball, ball and cushion in one line, touching: the ball must rebound into the cue ball.
    const double y = nine_foot().half_playing_m.y - kRadius_m;
    Diagnostics diagnostics;
    const auto record =
        solved(nine_foot(), {}, {ball_at(0, {0.3, y - kDiameter_m}, {0, 2}), ball_at(1, {0.3, y})},
               &diagnostics);
    EXPECT_LT(state_of(record, 0, 0.0).velocity_mps.y, 0.0);
    EXPECT_LE(state_of(record, 1, 0.0).velocity_mps.y, 0.0);
    EXPECT_LT(diagnostics.max_energy_rise_j, 1e-12);
    EXPECT_TRUE(events_of(record, EventKind::Cushion).at(0).held);
}

TEST(Island, APressedContactBouncesByMicrometresAndEnds) {
    // Strong follow on a ball frozen to a cushion, driven into it.
    const double y = nine_foot().half_playing_m.y - kRadius_m;
    Diagnostics diagnostics;
    const auto record =
        solved(nine_foot(), {}, {ball_at(1, {0.3, y}, {}, {-150, 0, 0})}, &diagnostics);
    const auto contacts = events_of(record, EventKind::Cushion);
    EXPECT_GT(contacts.size(), 5U);
    EXPECT_LT(contacts.size(), 1000U);
    for (const auto& contact : contacts) EXPECT_TRUE(contact.held);
    for (const auto& segment : track_of(record, 1).segments) {
        if (segment.start_s > contacts.back().time_s) break;
        EXPECT_NEAR(segment.position_m.y, y, 1e-5);
    }
    EXPECT_LT(diagnostics.max_energy_rise_j, 1e-12);
}

TEST(Island, ASlowTouchPassesOnItsSpeedAndNoMore) {
    const double slow = 0.003;
    const auto record =
        solved(model::open_table(), {},
               {ball_at(0, {-kDiameter_m - 1e-4, 0}, {slow, 0}, rolling_spin({slow, 0})),
                ball_at(1, {0, 0})});
    ASSERT_TRUE(events_of(record, EventKind::BallBall).empty()) << "it stops short";
    const auto nearer =
        solved(model::open_table(), {},
               {ball_at(0, {-kDiameter_m - 2e-5, 0}, {slow, 0}, rolling_spin({slow, 0})),
                ball_at(1, {0, 0})});
    const double hit_s = events_of(nearer, EventKind::BallBall).at(0).time_s;
    const double arriving = state_of(nearer, 0, std::nextafter(hit_s, 0.0)).velocity_mps.x;
    EXPECT_NEAR(state_of(nearer, 1, hit_s).velocity_mps.x, arriving, 1e-9);
}

TEST(Island, OverlapsOfAMicrometreCountAsTouching) {
    Diagnostics diagnostics;
    const auto record =
        solved(model::open_table(), {},
               {ball_at(0, {-kDiameter_m + 9e-7, 0}, {1, 0}), ball_at(1, {0, 0})}, &diagnostics);
    EXPECT_EQ(events_of(record, EventKind::BallBall).at(0).time_s, 0.0);
    EXPECT_GT(*diagnostics.min_gap_m, -1e-9) << "exempt until it has opened";
    const auto parting =
        solved(model::open_table(), {},
               {ball_at(0, {-kDiameter_m + 9e-7, 0}, {-1, 0}), ball_at(1, {0, 0})});
    EXPECT_TRUE(events_of(parting, EventKind::BallBall).empty());
}

}  // namespace
}  // namespace billiards::physics
