// Holds whole shots, from strike to rest, against an integration in small steps that comes nearer
// the smaller they are.
#include "tests/common/physics/stepped_world.h"
#include "tests/common/physics/still_life.h"

#include <string>

namespace billiards::physics {
namespace {

const SteppedBox kBox{.nose_height_m = 0.635 * 2 * kRadius_m};

model::TableSpec engine_box() {
    const Vec2 half = kBox.half_m;
    model::TableSpec table;
    table.cushions = {{{-half.x, -half.y}, {-half.x, half.y}},
                      {{half.x, -half.y}, {half.x, half.y}},
                      {{-half.x, -half.y}, {half.x, -half.y}},
                      {{-half.x, half.y}, {half.x, half.y}}};
    table.nose_height_m = kBox.nose_height_m;
    return table;
}

std::string name_of(SteppedEvent::Kind kind, std::size_t ball, std::size_t other) {
    const char* word = kind == SteppedEvent::Kind::BallBall  ? " meets "
                       : kind == SteppedEvent::Kind::Cushion ? " at cushion "
                                                             : " lands ";
    return std::to_string(ball) + word + std::to_string(other);
}

std::vector<std::string> order_of(const timeline::ShotRecord& record) {
    using enum SteppedEvent::Kind;
    std::vector<std::string> names;
    for (const model::ShotEvent& event : record.events) {
        if (event.kind == EventKind::BallBall)
            names.push_back(name_of(BallBall, event.ball.number, event.other.number));
        if (event.kind == EventKind::Cushion)
            names.push_back(name_of(Cushion, event.ball.number, event.index));
        if (event.kind == EventKind::Landing)
            names.push_back(name_of(Landing, event.ball.number, 0));
    }
    return names;
}

std::vector<std::string> order_of(const std::vector<SteppedEvent>& events) {
    std::vector<std::string> names;
    for (const SteppedEvent& event : events)
        names.push_back(name_of(event.kind, event.ball, event.other));
    return names;
}

/// How far from the engine's the places of rest are that steps of dt lead to.
double error_m(const timeline::ShotRecord& record, const std::vector<BallStart>& balls, double dt) {
    SteppedWorld world({}, kBox, balls);
    world.run(dt);
    EXPECT_EQ(order_of(world.events()), order_of(record)) << "with steps of " << dt << " s";
    double largest = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Vec3 rest = state_of(record, static_cast<int>(i), record.duration_s).position_m;
        largest = std::max(largest, glm::distance(rest, world.balls()[i].position_m));
    }
    return largest;
}

void expect_convergence(const std::vector<BallStart>& balls, std::size_t least_events) {
    const auto record = solved(engine_box(), {}, balls);
    EXPECT_GE(order_of(record).size(), least_events);
    const double coarse = error_m(record, balls, 1e-3);
    const double fine = error_m(record, balls, 1e-4);
    const double finest = error_m(record, balls, 1e-5);
    EXPECT_LT(fine, 0.3 * coarse);
    EXPECT_LT(finest, 0.3 * fine);
    EXPECT_LT(finest, 2e-5);
}

TEST(WholeShot, OfOneBallWithEnglishAroundTheTable) {
    expect_convergence({ball_at(0, {-0.5, 0.1}, {2.2, 1.4}, {0, 0, 90})}, 4);
}

TEST(WholeShot, OfACurveAndThreeCushions) {
    expect_convergence({ball_at(0, {0.3, -0.2}, {-1.5, 1.8}, {60, 40, -50})}, 3);
}

TEST(WholeShot, OfADrawThatComesBackToACushion) {
    expect_convergence(
        {ball_at(0, {-0.2, 0.05}, {2.5, 0.02}, {0, -120, 20}), ball_at(1, {0.2, 0.06})}, 3);
}

TEST(WholeShot, OfAFollowThatMeetsTwo) {
    expect_convergence({ball_at(0, {-0.7, 0.0}, {2.0, 0.03}, {0, 70, 0}), ball_at(1, {-0.2, 0.02}),
                        ball_at(2, {0.35, 0.012})},
                       3);
}

TEST(WholeShot, OfUnequalBalls) {
    std::vector<BallStart> balls{ball_at(0, {-0.4, 0.1}, {1.8, -0.2}, {0, 0, -60}),
                                 ball_at(1, {0.1, 0.05})};
    balls[1].spec.mass_kg *= 1.6;
    expect_convergence(balls, 2);
}

TEST(WholeShot, OfAJumpOverABallWithThreeBounces) {
    std::vector<BallStart> balls{ball_at(0, {-0.6, 0.0}, {1.2, 0.1}, {10, -30, 40}),
                                 ball_at(1, {-0.4, 0.02})};
    balls[0].velocity_mps.z = 1.5;
    expect_convergence(balls, 4);
}

}  // namespace
}  // namespace billiards::physics
