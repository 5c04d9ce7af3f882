// Holds the integrated impact against the equations of its paper, integrated here by themselves.
#include "common/physics/cushion_mathavan.h"

#include "tests/common/physics/lone_ball.h"

namespace billiards::physics {
namespace {

/// The ball and the friction that the paper found (its sections 3 and 4).
constexpr model::BallSpec kSnookerBall{.radius_m = 0.02625, .mass_kg = 0.1406};
constexpr double kSnookerLean = 0.4;

Parameters snooker() {
    Parameters parameters = with_cushion(CushionModel::Mathavan2010, 0.98, 0.14);
    parameters.sliding_friction = 0.212;
    return parameters;
}

/// The paper's frame: x along the cushion, y into it. Its equations 12 to 17, in its symbols.
struct PaperBall {
    double x, y;        ///< Velocities of the centre.
    double wx, wy, wz;  ///< Spin.
    double work = 0.0;
};

PaperBall rates(const Parameters& p, const PaperBall& b, const model::BallSpec& spec, double sine) {
    const double cosine = std::sqrt(1 - sine * sine);
    const double m = spec.mass_kg;
    const double r = spec.radius_m;
    const double xi = b.x + b.wy * r * sine - b.wz * r * cosine;
    const double yi = -b.y * sine + b.wx * r;
    const double xc = b.x - b.wy * r;
    const double yc = b.y + b.wx * r;
    const double si = std::hypot(xi, yi);
    const double sc = std::hypot(xc, yc);
    const double cos_i = si > 0 ? xi / si : 1;
    const double sin_i = si > 0 ? yi / si : 0;
    const double cos_c = sc > 0 ? xc / sc : 1;
    const double sin_c = sc > 0 ? yc / sc : 0;
    const double mu_w = p.cushion_friction;
    const double slate = p.sliding_friction * (sine + mu_w * sin_i * cosine);
    return {-(mu_w * cos_i + slate * cos_c) / m,
            -(cosine - mu_w * sine * sin_i + slate * sin_c) / m,
            -2.5 / (m * r) * (mu_w * sin_i + slate * sin_c),
            -2.5 / (m * r) * (mu_w * cos_i * sine - slate * cos_c),
            2.5 / (m * r) * mu_w * cos_i * cosine,
            b.y * cosine};
}

PaperBall moved(const PaperBall& b, const PaperBall& rate, double impulse) {
    return {b.x + rate.x * impulse,   b.y + rate.y * impulse,   b.wx + rate.wx * impulse,
            b.wy + rate.wy * impulse, b.wz + rate.wz * impulse, b.work + rate.work * impulse};
}

/// The paper's procedure with `steps` midpoint steps a phase or so, and a last one cut to length.
Body integrated(const Parameters& p, const Body& ball, double sine, double steps) {
    const Vec3& v = ball.state.velocity_mps;
    const Vec3& w = ball.state.spin_radps;
    // Into the cushion is +x here and +y there: a quarter turn.
    PaperBall b{-v.y, v.x, -w.y, w.x, w.z};
    const double step = ball.spec.mass_kg * v.x / steps;
    const auto next = [&](double impulse) {
        const PaperBall half = moved(b, rates(p, b, ball.spec, sine), impulse / 2);
        return moved(b, rates(p, half, ball.spec, sine), impulse);
    };
    PaperBall after = next(step);
    for (; after.y > 0; after = next(step)) b = after;
    b = next(step * b.y / (b.y - after.y));
    const double e = p.cushion_restitution;
    const double kept = (1 - e * e) * b.work;
    for (after = next(step); after.work > kept; after = next(step)) b = after;
    b = next(step * (b.work - kept) / (b.work - after.work));
    Body result = ball;
    result.state.velocity_mps = {b.y, -b.x, 0};
    result.state.spin_radps = {b.wy, -b.wx, b.wz};
    return result;
}

/// Top spin k times that of rolling, side spin k times as much, the paper's angle to the cushion.
Body incident(double angle_rad, double top, double side) {
    const double r = kSnookerBall.radius_m;
    const Vec3 v{std::sin(angle_rad), -std::cos(angle_rad), 0};
    return lone_ball(v, {-top * v.y / r, top * v.x / r, side / r}, kSnookerBall);
}

TEST(MathavanCushion, FollowsThePapersEquationsWhereAllSlips) {
    for (const double degrees : {10.0, 30.0, 50.0, 80.0}) {
        for (const double side : {-2.0, -1.0, 1.0, 2.0}) {
            const Body ball = incident(base::radians(degrees), 2.0, side);
            const Body expected = integrated(snooker(), ball, kSnookerLean, 4e4);
            EXPECT_LT(distance_of(bounced(snooker(), ball, kSnookerLean), expected), 1e-9)
                << degrees << " degrees, side spin " << side;
        }
    }
}

TEST(MathavanCushion, FollowsThePapersEquationsThroughRollingStickingAndTurning) {
    for (const double degrees : {15.0, 45.0, 75.0, 90.0}) {
        for (const double top : {-1.0, 0.0, 1.0}) {
            const Body ball = incident(base::radians(degrees), top, 0.0);
            const Body expected = integrated(snooker(), ball, kSnookerLean, 5e4);
            EXPECT_LT(distance_of(bounced(snooker(), ball, kSnookerLean), expected), 5e-5)
                << degrees << " degrees, top spin " << top;
        }
    }
}

TEST(MathavanCushion, FollowsThePapersEquationsForPoolBallsOnSlowAndFastCloth) {
    for (const double cloth : {0.05, 0.2, 0.4}) {
        Parameters parameters = with_cushion(CushionModel::Mathavan2010, 0.85, 0.2);
        parameters.sliding_friction = cloth;
        for (const Vec3& spin : {Vec3{0, 0, 0}, Vec3{-35, 70, 0}, Vec3{40, -60, 90}}) {
            const Body ball = lone_ball({2, 1, 0}, spin);
            const Body expected = integrated(parameters, ball, 0.27, 5e4);
            EXPECT_LT(distance_of(bounced(parameters, ball), expected), 1e-4) << cloth;
        }
    }
}

TEST(MathavanCushion, FollowsThePapersEquationsForAnyBall) {
    base::Random random(77);
    for (int i = 0; i < 60; ++i) {
        // Friction at the nose that cannot lift the ball: there the equations would have the slate
        // pull.
        Parameters parameters = with_cushion(CushionModel::Mathavan2010, random.uniform(0.6, 1.0),
                                             random.uniform(0.0, 0.25));
        parameters.sliding_friction = random.uniform(0.0, 0.4);
        Body ball = random_ball(random);
        ball.state.velocity_mps.x += 0.5;
        if (i % 2 == 0) ball.state.spin_radps = rolling_spin(ball.state.velocity_mps);
        const double scale =
            speed_of(ball.state.velocity_mps) + kRadius_m * speed_of(ball.state.spin_radps);
        const Body expected = integrated(parameters, ball, 0.27, 2e4);
        EXPECT_LT(distance_of(bounced(parameters, ball), expected) / scale, 1e-4) << i;
    }
}

TEST(MathavanCushion, WithoutFrictionIsAMirrorWithRestitution) {
    for (const double e : {0.0, 0.5, 0.85, 1.0}) {
        Parameters parameters = with_cushion(CushionModel::Mathavan2010, e, 0.0);
        parameters.sliding_friction = 0.0;
        const Body ball = lone_ball({2, 1, 0}, {30, -20, 50});
        const Body after = bounced(parameters, ball);
        EXPECT_NEAR(after.state.velocity_mps.x, -2 * e, 1e-13);
        EXPECT_NEAR(after.state.velocity_mps.y, 1.0, 1e-15);
        EXPECT_EQ(after.state.spin_radps, ball.state.spin_radps);
    }
}

/// The nose's point slips down it at v sin until P1 = v sin / ((5/2 + sin^2) mu + sin cos); from
/// there on friction sin cos / (5/2 + sin^2) holds it. Work is quadratic in P on either side.
TEST(MathavanCushion, AStunnedBallThatSticksFollowsItsClosedForm) {
    Parameters parameters = with_cushion(CushionModel::Mathavan2010, 1.0, 0.4);
    parameters.sliding_friction = 0.0;
    const double sine = 0.27;
    const double cosine = std::sqrt(1 - sine * sine);
    const double give = 2.5 + sine * sine;
    const double v = 2.0;
    const double slips = sine * v / (give * 0.4 + sine * cosine);
    const double slowing = cosine + sine * 0.4;
    const double holding = cosine - sine * sine * cosine / give;
    const double v1 = v - slowing * slips;
    ASSERT_GT(v1, 0.0) << "sticks before it has stopped";
    const double work = cosine * (slips * (v + v1) / 2 + v1 * v1 / holding / 2);
    const double v2 = -std::sqrt(2 * holding * work / cosine);
    const Body after = bounced(parameters, lone_ball({v, 0, 0}, {}), sine);
    EXPECT_NEAR(after.state.velocity_mps.x, v2, 1e-9);
    EXPECT_EQ(after.state.velocity_mps.y, 0.0);
}

TEST(MathavanCushion, NeverAddsEnergyAndAlwaysSendsTheBallBack) {
    base::Random random(3);
    for (int i = 0; i < 300; ++i) {
        Parameters parameters = with_cushion(CushionModel::Mathavan2010, random.uniform(0.5, 1.0),
                                             random.uniform(0.0, 0.4));
        parameters.sliding_friction = random.uniform(0.0, 0.4);
        const Body ball = random_ball(random);
        const Body after = bounced(parameters, ball);
        EXPECT_LE(energy_of(after), energy_of(ball) + 1e-13);
        EXPECT_LT(after.state.velocity_mps.x, 0.0);
    }
}

TEST(MathavanCushion, MirrorsAMirroredBallBitForBit) {
    base::Random random(4);
    const Parameters parameters = with_cushion(CushionModel::Mathavan2010, 0.85, 0.2);
    for (int i = 0; i < 50; ++i) {
        const Body ball = random_ball(random);
        Body mirrored = ball;
        mirrored.state.velocity_mps *= Vec3{1, -1, 1};
        mirrored.state.spin_radps *= Vec3{-1, 1, -1};
        const Body after = bounced(parameters, ball);
        const Body other = bounced(parameters, mirrored);
        EXPECT_EQ(other.state.velocity_mps, after.state.velocity_mps * Vec3(1, -1, 1));
        EXPECT_EQ(other.state.spin_radps, after.state.spin_radps * Vec3(-1, 1, -1));
    }
}

TEST(MathavanCushion, ABallInTheAirTouchesNoSlate) {
    Body ball = lone_ball({2, 1, 0.3}, {30, -20, 50});
    ball.is_on_slate = false;
    const Body after = bounced(with_cushion(CushionModel::Mathavan2010, 0.85, 0.2), ball, 0.1);
    const Body han = bounced(with_cushion(CushionModel::Han2005, 0.85, 0.2), ball, 0.1);
    EXPECT_EQ(after.state, han.state);
}

TEST(MathavanCushion, ABallThatWedgesComesBackWithoutFriction) {
    Parameters parameters = with_cushion(CushionModel::Mathavan2010, 0.5, 0.8);
    parameters.sliding_friction = 0.8;
    const Vec2 velocity{2, 5};
    const Body after = bounced(parameters, lone_ball({velocity, 0}, rolling_spin(velocity)), 0.82);
    EXPECT_NEAR(after.state.velocity_mps.x, -1.0, 1e-14);
    EXPECT_EQ(after.state.velocity_mps.y, 5.0);
}

}  // namespace
}  // namespace billiards::physics
