// Holds the strike of the cue against closed forms.
#include "common/physics/cue.h"

#include "tests/common/physics/still_life.h"

#include <limits>

namespace billiards::physics {
namespace {

const Parameters kRealistic = realistic_parameters();

Strike struck(const model::Shot& shot, bool squirt = false) {
    return strike(kRealistic, {}, shot, cue_speed_mps(kRealistic, {}, shot.power), squirt);
}

TEST(Cue, SendsTheBallAwayAtTheSpringsSpeed) {
    EXPECT_NEAR(struck({.power = 1.0}).velocity_mps.x, 200 * 0.01 / kMass_kg, 1e-13);
    EXPECT_NEAR(struck({.power = 1.0}).velocity_mps.x, 11.76, 0.01);
    EXPECT_NEAR(struck({.power = 0.5}).velocity_mps.x, 100 * 0.01 / kMass_kg, 1e-13);
}

TEST(Cue, PointsWhereTheAngleSays) {
    const Strike up = struck({.angle_rad = base::kPi / 2, .power = 0.5});
    EXPECT_NEAR(up.velocity_mps.x, 0.0, 1e-14);
    EXPECT_GT(up.velocity_mps.y, 5.0);
    EXPECT_EQ(up.spin_radps, Vec3(0, 0, 0));
}

TEST(Cue, SpinFollowsTheOffset) {
    const Strike follow = struck({.power = 0.5, .tip_up = 0.4});
    EXPECT_NEAR(follow.spin_radps.y, 2.5 * follow.velocity_mps.x * 0.4 / kRadius_m, 1e-11)
        << "two fifths above the centre is natural roll";
    EXPECT_LT(struck({.power = 0.5, .tip_up = -0.4}).spin_radps.y, 0.0);
    EXPECT_LT(struck({.power = 0.5, .tip_left = 0.3}).spin_radps.z, 0.0) << "clockwise from above";
    EXPECT_GT(struck({.power = 0.5, .tip_left = -0.3}).spin_radps.z, 0.0);
}

TEST(Cue, OffCentreHitsLoseSpeed) {
    const double mass_ratio = kMass_kg / kRealistic.cue_mass_kg;
    const double centre = struck({.power = 0.5}).velocity_mps.x;
    const double off = struck({.power = 0.5, .tip_left = 0.3, .tip_up = 0.4}).velocity_mps.x;
    EXPECT_NEAR(off / centre, (1 + mass_ratio) / (1 + mass_ratio + 2.5 * 0.25), 1e-14);
}

TEST(Cue, SquirtTurnsTheBallAwayFromTheOffset) {
    const Strike left = struck({.power = 0.5, .tip_left = 0.5}, true);
    const double a = 0.5;
    const double expected = 2.5 * a * std::sqrt(1 - a * a) / (1 + 30 + 2.5 * (1 - a * a));
    EXPECT_NEAR(left.velocity_mps.y / left.velocity_mps.x, -expected, 1e-14);
    const Strike straight = struck({.power = 0.5, .tip_left = 0.5}, false);
    EXPECT_NEAR(speed_of(left.velocity_mps), speed_of(straight.velocity_mps), 1e-14);
    EXPECT_EQ(left.spin_radps, straight.spin_radps);
}

TEST(Cue, AnElevatedHitDrivesTheBallIntoTheSlate) {
    const double elevation = base::radians(30);
    const Strike jump = struck({.power = 0.5, .elevation_rad = elevation});
    EXPECT_NEAR(jump.velocity_mps.z / jump.velocity_mps.x, -std::tan(elevation), 1e-14);
}

TEST(Cue, MomentumOfSpinIsTheImpulsesMoment) {
    // w = (5 / (2 R)) (r / R x v) with r / R = -c d + a l + b n, for any direction.
    const model::Shot shot{
        .angle_rad = 0.7, .power = 0.6, .tip_left = 0.2, .tip_up = -0.3, .elevation_rad = 0.4};
    const Strike result = struck(shot);
    const Vec3 d{std::cos(0.7) * std::cos(0.4), std::sin(0.7) * std::cos(0.4), -std::sin(0.4)};
    const Vec3 l{-std::sin(0.7), std::cos(0.7), 0};
    const Vec3 n = glm::cross(d, l);
    const Vec3 tip = -std::sqrt(1 - 0.13) * d + 0.2 * l - 0.3 * n;
    const Vec3 expected = 2.5 / kRadius_m * glm::cross(tip, result.velocity_mps);
    EXPECT_LT(speed_of(result.spin_radps - expected), 1e-10);
}

TEST(Cue, WithoutSpinIgnoresOffsetAndElevation) {
    const model::Shot shot{.power = 0.5, .tip_left = 0.3, .tip_up = 0.3, .elevation_rad = 0.5};
    const Strike result =
        strike(classic_parameters(), {}, shot, cue_speed_mps(classic_parameters(), {}, 0.5));
    EXPECT_NEAR(result.velocity_mps.x, 100 * 0.01 / kMass_kg, 1e-13);
    EXPECT_EQ(result.spin_radps, Vec3(0, 0, 0));
}

struct BadShot {
    model::Shot shot;
    ErrorCode code;
    const char* field;
};

TEST(Cue, RefusesNumbersThatMakeNoSense) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const BadShot cases[] = {
        {{.angle_rad = kNan}, ErrorCode::NotFinite, "angle_rad"},
        {{.angle_rad = 1e9}, ErrorCode::OutOfRange, "angle_rad"},
        {{.power = 0.0}, ErrorCode::OutOfRange, "power"},
        {{.power = -0.1}, ErrorCode::OutOfRange, "power"},
        {{.power = 1.01}, ErrorCode::OutOfRange, "power"},
        {{.power = kNan}, ErrorCode::NotFinite, "power"},
        {{.tip_left = 0.51}, ErrorCode::OutOfRange, "tip_left"},
        {{.tip_up = -0.51}, ErrorCode::OutOfRange, "tip_up"},
        {{.tip_left = 0.4, .tip_up = 0.4}, ErrorCode::OutOfRange, "tip offset"},
        {{.elevation_rad = -0.01}, ErrorCode::OutOfRange, "elevation_rad"},
        {{.elevation_rad = base::kPi / 2}, ErrorCode::OutOfRange, "elevation_rad"},
    };
    for (const BadShot& bad : cases) {
        const auto result = validate(bad.shot);
        ASSERT_FALSE(result.ok()) << bad.field;
        EXPECT_EQ(result.error(), (Error{bad.code, bad.field}));
    }
    EXPECT_TRUE(validate(model::Shot{.tip_left = 0.3, .tip_up = 0.4}).ok());
    EXPECT_TRUE(validate(model::Shot{.power = 1.0}).ok());
}

}  // namespace
}  // namespace billiards::physics
