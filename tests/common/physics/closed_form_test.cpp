// Holds shots against what can be written down for them: follow, draw, stun, curve, throw and jump.
#include "common/physics/collide_ball.h"
#include "common/physics/cue.h"
#include "common/physics/motion.h"
#include "tests/common/physics/still_life.h"

#include <rapidcheck/gtest.h>

namespace billiards::physics {
namespace {

constexpr double kExact = 1e-9;
constexpr double kDiameter_m = 2 * kRadius_m;
const Parameters kRealistic = realistic_parameters();
const double kSliding_mps2 = kRealistic.sliding_friction * kRealistic.gravity_mps2;
const double kRolling_mps2 = kRealistic.rolling_friction * kRealistic.gravity_mps2;

/// Where a ball comes to rest along a line, that starts at 0 with this speed and this R w.
double path_m(double speed_mps, double rim_mps) {
    const double slip = speed_mps - rim_mps;
    const double slide_s = 2 * std::abs(slip) / (7 * kSliding_mps2);
    const double rolling = (5 * speed_mps + 2 * rim_mps) / 7;
    return (speed_mps + rolling) / 2 * slide_s + rolling * std::abs(rolling) / (2 * kRolling_mps2);
}

/// Ball 0 at `speed` with R w = rim, straight into ball 1.
timeline::ShotRecord straight(const Parameters& parameters, double speed, double rim) {
    return solved(
        model::open_table(), parameters,
        {ball_at(0, {-kDiameter_m, 0}, {speed, 0}, {0, rim / kRadius_m, 0}), ball_at(1, {0, 0})});
}

double rest_x(const timeline::ShotRecord& record, int ball) {
    return record.final_layout.find(BallId{static_cast<std::uint8_t>(ball)})->position_m.x;
}

TEST(ClosedForm, ElasticFollowAndDrawGoAsFarAsTheirSpinDrives) {
    Parameters elastic;
    elastic.ball_ball = BallBallModel::Elastic;
    for (const double rim : {-2.5, -1.0, -0.5, 1.5}) {
        const auto record = straight(elastic, 1.5, rim);
        EXPECT_NEAR(rest_x(record, 0), -kDiameter_m + path_m(0.0, rim), kExact);
        EXPECT_NEAR(rest_x(record, 1), path_m(1.5, 0.0), kExact);
    }
    // A rolling ball follows at 2/7 of its speed.
    EXPECT_NEAR(path_m(0.0, 1.5), 1.5 * 1.5 * (2 / (49 * kSliding_mps2) + 2 / (49 * kRolling_mps2)),
                kExact);
}

TEST(ClosedForm, FrictionBetweenBallsTakesFromFollowAndDrawWhatItGivesTheOther) {
    const double e = kRealistic.ball_ball_restitution;
    const double v = 2.0;
    for (const double rim : {-3.0, -0.5, 0.0, 2.0}) {
        const double rub =
            std::min(ball_friction(kRealistic, std::abs(rim)) * (1 + e) / 2 * v, std::abs(rim) / 7);
        const double taken = std::copysign(2.5 * rub, rim);
        const auto record = straight(kRealistic, v, rim);
        EXPECT_NEAR(rest_x(record, 0), -kDiameter_m + path_m((1 - e) / 2 * v, rim - taken), kExact);
        EXPECT_NEAR(rest_x(record, 1), path_m((1 + e) / 2 * v, -taken), kExact);
    }
}

RC_GTEST_PROP(ClosedForm, ASlideIsAParabolaThatEndsInTheNaturalRoll, ()) {
    base::Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Vec2 v{random.uniform(-5, 5), random.uniform(-5, 5)};
    const Vec3 spin{random.uniform(-150, 150), random.uniform(-150, 150), random.uniform(-50, 50)};
    const auto record = solved(model::open_table(), kRealistic, {ball_at(1, {0, 0}, v, spin)});
    // u = v + R (z x w).
    const Vec2 slip = v + kRadius_m * Vec2{-spin.y, spin.x};
    const double slide_s = 2 * glm::length(slip) / (7 * kSliding_mps2);
    const auto& rolling = track_of(record, 1).segments.at(1);
    RC_ASSERT(std::abs(rolling.start_s - slide_s) < kExact);
    for (const double share : {0.3, 0.7, 1.0}) {
        const double t = share * slide_s;
        const Vec2 place = v * t - 0.5 * kSliding_mps2 * t * t * glm::normalize(slip);
        RC_ASSERT(glm::distance(base::horizontal(state_of(record, 1, t).position_m), place) <
                  kExact);
    }
    const Vec2 natural = v - 2.0 / 7.0 * slip;
    RC_ASSERT(glm::distance(base::horizontal(rolling.velocity_mps), natural) < kExact);
}

/// The throw of a stun shot: tan = mu(s) where it slips to the end, else what stops the slip
/// (Alciatore TP A-14). s = v sin(cut).
double throw_rad(double speed_mps, double cut_rad) {
    const double e = kRealistic.ball_ball_restitution;
    const double across = speed_mps * std::sin(cut_rad);
    const double along = (1 + e) / 2 * speed_mps * std::cos(cut_rad);
    return std::atan(std::min(ball_friction(kRealistic, across) * along, across / 7) / along);
}

double measured_throw_rad(double speed_mps, double cut_rad) {
    const Vec2 normal = unit_vector(cut_rad);
    const auto record =
        solved(model::open_table(), kRealistic,
               {ball_at(0, -kDiameter_m * normal, {speed_mps, 0}), ball_at(1, {0, 0})});
    const Vec3 v = track_of(record, 1).segments.front().velocity_mps;
    return cut_rad - std::atan2(v.y, v.x);
}

TEST(ClosedForm, ThrowFollowsItsFormulaPeaksBelowSixDegreesAndFallsWithSpeed) {
    double peak = 0.0;
    for (double cut = 0.05; cut < 1.5; cut += 0.05) {
        double slower = 1.0;
        for (const double speed : {0.3, 1.0, 3.0, 8.0}) {
            const double thrown = measured_throw_rad(speed, cut);
            EXPECT_NEAR(thrown, throw_rad(speed, cut), kExact);
            EXPECT_LE(thrown, slower + kExact);
            slower = thrown;
            peak = std::max(peak, thrown);
        }
    }
    EXPECT_GT(base::degrees(peak), 4.0);
    EXPECT_LT(base::degrees(peak), 6.0);
}

TEST(ClosedForm, AJumpShotRisesAsHighAsTheSlateSendsItBack) {
    const model::Shot shot{.power = 0.4, .elevation_rad = base::radians(35)};
    const model::Layout layout{{{.ball = model::kCueBall, .position_m = {0, 0}}}};
    const auto record = simulate_shot(model::open_table(), kRealistic, layout, shot);
    ASSERT_TRUE(record.ok());
    const model::BallSpec ball;
    const Strike struck =
        strike(kRealistic, ball, shot, cue_speed_mps(kRealistic, ball, shot.power));
    const double g = kRealistic.gravity_mps2;
    const double rise = -kRealistic.ball_table_restitution * struck.velocity_mps.z;
    const double top_s = rise / g;
    EXPECT_NEAR(state_of(*record, 0, top_s).position_m.z, kRadius_m + rise * rise / (2 * g),
                kExact);
    const auto landings = events_of(*record, EventKind::Landing);
    ASSERT_GE(landings.size(), 3U);
    EXPECT_EQ(landings[0].time_s, 0.0) << "driven into the slate";
    EXPECT_NEAR(landings[1].time_s, 2 * top_s, kExact);
    EXPECT_NEAR(landings[2].time_s, 3 * top_s, kExact) << "half the speed, half the time";
    // Coulomb's friction with the slate at the first touch: it slips throughout.
    const double grip = kRealistic.sliding_friction * (rise - struck.velocity_mps.z);
    const double level = std::max(5.0 / 7.0 * struck.velocity_mps.x, struck.velocity_mps.x - grip);
    EXPECT_NEAR(state_of(*record, 0, top_s).velocity_mps.x, level, kExact);
}

}  // namespace
}  // namespace billiards::physics
