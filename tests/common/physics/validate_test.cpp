// Holds that every bad input has its own error, and names what is wrong.
#include "common/physics/validate.h"

#include "tests/common/physics/still_life.h"

#include <limits>

namespace billiards::physics {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Error error_of(const std::vector<BallStart>& balls, const model::TableSpec& table = nine_foot(),
               const Parameters& parameters = {}) {
    const auto record = simulate(table, parameters, balls);
    return record.ok() ? Error{} : record.error();
}

BallStart with(BallStart ball, auto change) {
    change(ball);
    return ball;
}

TEST(Validate, NamesBadNumbersOfABall) {
    const BallStart good = ball_at(3, {0, 0});
    EXPECT_EQ(error_of({with(good, [](auto& b) { b.position_m.y = kNan; })}),
              (Error{ErrorCode::NotFinite, "ball 3 position_m.y"}));
    EXPECT_EQ(error_of({with(good, [](auto& b) { b.velocity_mps.x = kInfinity; })}),
              (Error{ErrorCode::NotFinite, "ball 3 velocity_mps.x"}));
    EXPECT_EQ(error_of({with(good, [](auto& b) { b.spin_radps.z = kNan; })}),
              (Error{ErrorCode::NotFinite, "ball 3 spin_radps.z"}));
    EXPECT_EQ(error_of({with(good, [](auto& b) { b.velocity_mps.x = 1e4; })}),
              (Error{ErrorCode::OutOfRange, "ball 3 velocity_mps.x"}));
    EXPECT_EQ(error_of({with(good, [](auto& b) { b.spec.mass_kg = 0; })}),
              (Error{ErrorCode::OutOfRange, "ball 3 mass_kg"}));
    EXPECT_EQ(error_of({with(good, [](auto& b) { b.spec.radius_m = -1; })}),
              (Error{ErrorCode::OutOfRange, "ball 3 radius_m"}));
    EXPECT_EQ(error_of({with(good, [](auto& b) { b.ball.number = 22; })}),
              (Error{ErrorCode::OutOfRange, "ball 22 id"}));
}

TEST(Validate, CountsBalls) {
    EXPECT_EQ(error_of({}).code, ErrorCode::TooManyBalls);
    std::vector<BallStart> many;
    for (int i = 0; i < 23; ++i) many.push_back(ball_at(i % 22, {-1.1 + 0.1 * i, 0}));
    EXPECT_EQ(error_of(many).code, ErrorCode::TooManyBalls);
    EXPECT_EQ(error_of({ball_at(4, {0, 0}), ball_at(4, {1, 0})}),
              (Error{ErrorCode::DuplicateBall, "ball 4, ball 4"}));
}

model::TableSpec table_with_wall(std::size_t times) {
    model::TableSpec table = model::open_table();
    table.nose_height_m = 0.036;
    table.cushions.assign(times, {{0.5, -1}, {0.5, 1}});
    return table;
}

TEST(Validate, CountsThePartsOfATable) {
    EXPECT_EQ(error_of({ball_at(1, {0, 0})}, table_with_wall(kMostParts + 1)),
              (Error{ErrorCode::OutOfRange, "cushions, more than 64"}));
}

TEST(Validate, AWallThatStandsManyTimesInOnePlaceIsOneThatBallsComeBackFrom) {
    const BallStart ball = with(ball_at(1, {0, 0}), [](BallStart& b) {
        b.velocity_mps = {2, 0, 0};
    });
    const auto record =
        simulate(table_with_wall(kMostParts), Parameters{}, std::vector<BallStart>{ball});
    ASSERT_TRUE(record.ok()) << record.error().detail;
    EXPECT_LT(record->final_layout.balls[0].position_m.x, 0.5 - kRadius_m);
}

TEST(Validate, NamesWhatOverlaps) {
    EXPECT_EQ(error_of({ball_at(1, {0, 0}), ball_at(2, {2 * kRadius_m - 2e-6, 0})}),
              (Error{ErrorCode::Overlap, "ball 1, ball 2"}));
    EXPECT_EQ(error_of({ball_at(1, {0.3, 0.635 - kRadius_m + 2e-6})}),
              (Error{ErrorCode::Overlap, "ball 1, cushion 3"}));
    EXPECT_EQ(error_of({with(ball_at(1, {0, 0}), [](auto& b) { b.position_m.z -= 1e-3; })}),
              (Error{ErrorCode::Overlap, "ball 1, slate"}));
    const Vec2 jaw = nine_foot().jaws[0].center_m;
    EXPECT_EQ(error_of({ball_at(1, jaw + Vec2{0, 0.02})}).code, ErrorCode::Overlap);
}

TEST(Validate, TakesAnOverlapOfAMicrometreThatItsCoordinatesRoundUp) {
    const double second = 2 * kRadius_m - 1e-6;
    ASSERT_LT(second - kRadius_m - kRadius_m, -1e-6);
    const double wall = 0.635 - kRadius_m + 1e-6;
    ASSERT_LT(0.635 - wall - kRadius_m, -1e-6);
    const std::vector<BallStart> balls{ball_at(1, {0, 0}), ball_at(2, {second, 0}),
                                       ball_at(3, {0.3, wall})};
    EXPECT_TRUE(simulate(nine_foot(), {}, balls).ok());
}

TEST(Validate, RefusesBallsOutsideTheTable) {
    EXPECT_EQ(error_of({ball_at(1, {5, 0})}), (Error{ErrorCode::OutsideTable, "ball 1"}));
    EXPECT_EQ(error_of({ball_at(1, {0.3, 0.635 + 0.1})}),
              (Error{ErrorCode::OutsideTable, "ball 1"}))
        << "on a rail";
    EXPECT_EQ(error_of({ball_at(1, nine_foot().pockets[4].center_m)}),
              (Error{ErrorCode::OutsideTable, "ball 1 lies in pocket 4"}));
}

TEST(Validate, AllowsAWholeTableOfFrozenBalls) {
    EXPECT_TRUE(simulate(nine_foot(), {}, break_shot(nine_foot(), {1, 0})).ok());
}

TEST(Validate, NamesBadParameters) {
    Parameters parameters;
    parameters.ball_ball_restitution = 1.1;
    EXPECT_EQ(error_of({ball_at(1, {0, 0})}, nine_foot(), parameters),
              (Error{ErrorCode::OutOfRange, "ball_ball_restitution"}));
    parameters = {};
    parameters.gravity_mps2 = kNan;
    EXPECT_EQ(error_of({ball_at(1, {0, 0})}, nine_foot(), parameters),
              (Error{ErrorCode::NotFinite, "gravity_mps2"}));
}

TEST(Validate, TellsATableThatLostItsCushionsFromAnOpenOne) {
    model::TableSpec table = nine_foot();
    table.cushions.clear();
    EXPECT_EQ(error_of({ball_at(1, {0, 0})}, table), (Error{ErrorCode::OutOfRange, "cushions"}));
    EXPECT_TRUE(validate(model::open_table()).ok());
}

TEST(Validate, NamesBadTables) {
    model::TableSpec table = model::open_table();
    table.cushions = {{{1, 1}, {1, 1}}};
    EXPECT_EQ(error_of({ball_at(1, {0, 0})}, table), (Error{ErrorCode::OutOfRange, "cushions[0]"}));
    table = model::open_table();
    table.pockets = {{{1, kNan}, 0.1}};
    EXPECT_EQ(error_of({ball_at(1, {0, 0})}, table),
              (Error{ErrorCode::NotFinite, "pockets[0].center.y"}));
}

}  // namespace
}  // namespace billiards::physics
