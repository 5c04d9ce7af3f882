// Takes layouts told ball by ball; gives whether balls may be, and are, put where the rules say.
#include "common/match/placement.h"

#include "tests/common/match/layouts.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace billiards::match {
namespace {

using base::Vec2;
using rules::Zone;

constexpr double kDiameter_m = 2 * kRadius_m;
const Vec2 kSpot_m = model::foot_spot(nine_foot());

std::optional<RefusalCode> refusal(const model::Layout& layout, Zone zone, Vec2 position_m) {
    const auto checked = check_placement(nine_foot(), layout, zone, position_m);
    if (checked) return std::nullopt;
    return checked.error().code;
}

Vec2 spotted(model::Layout layout, int ball = 8) {
    layout.balls.push_back({id(ball), model::Place::Pocketed, {}});
    spot_balls(nine_foot(), layout, std::vector{id(ball)});
    return layout.find(id(ball))->position_m;
}

TEST(Placement, IsAllowedInsideTheCushionsUpToTouchingThem) {
    const model::Layout layout = layout_of({});
    const Vec2 reach_m = nine_foot().half_playing_m - kRadius_m;
    EXPECT_EQ(refusal(layout, Zone::Anywhere, {0, 0}), std::nullopt);
    EXPECT_EQ(refusal(layout, Zone::Anywhere, reach_m), std::nullopt);
    EXPECT_EQ(refusal(layout, Zone::Anywhere, -reach_m), std::nullopt);
    for (const Vec2 aside_m : {Vec2{1e-6, 0}, Vec2{0, 1e-6}}) {
        EXPECT_EQ(refusal(layout, Zone::Anywhere, reach_m + aside_m), RefusalCode::BadPlacement);
        EXPECT_EQ(refusal(layout, Zone::Anywhere, -reach_m - aside_m), RefusalCode::BadPlacement);
    }
}

TEST(Placement, IsRefusedForNumbersThatAreNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_EQ(refusal(layout_of({}), Zone::Anywhere, {bad, 0}), RefusalCode::BadPlacement);
        EXPECT_EQ(refusal(layout_of({}), Zone::Anywhere, {0, bad}), RefusalCode::BadPlacement);
    }
}

TEST(Placement, IsRefusedOverAPocket) {
    model::TableSpec table = nine_foot();
    table.pockets.push_back({{0.3, 0.0}, 0.05});
    const auto over = check_placement(table, layout_of({}), Zone::Anywhere, {0.34, 0.0});
    ASSERT_FALSE(over);
    EXPECT_EQ(over.error().code, RefusalCode::BadPlacement);
    EXPECT_TRUE(check_placement(table, layout_of({}), Zone::Anywhere, {0.36, 0.0}));
}

TEST(Placement, MustBeStrictlyBehindTheHeadStringWhereTheZoneSaysSo) {
    const double line_m = *nine_foot().head_string_m;
    const model::Layout layout = layout_of({});
    EXPECT_EQ(refusal(layout, Zone::BehindHeadString, {line_m, 0}), RefusalCode::BadPlacement);
    EXPECT_EQ(refusal(layout, Zone::BehindHeadString, {std::nextafter(line_m, -9), 0}),
              std::nullopt);
    EXPECT_EQ(refusal(layout, Zone::Anywhere, {line_m, 0}), std::nullopt);
}

TEST(Placement, MayTouchAnotherBallButNeverOverlapIt) {
    const model::Layout layout = layout_of({{3, {0.1, 0.2}}});
    EXPECT_EQ(refusal(layout, Zone::Anywhere, {0.1 + kDiameter_m, 0.2}), std::nullopt);
    EXPECT_EQ(refusal(layout, Zone::Anywhere, {0.1 + kDiameter_m - 1e-9, 0.2}),
              RefusalCode::BadPlacement);
}

TEST(Placement, IgnoresTheCueBallItselfAndBallsThatAreDown) {
    model::Layout layout = layout_of({{0, {0, 0}}, {3, {0.3, 0}}});
    EXPECT_EQ(refusal(layout, Zone::Anywhere, {0.01, 0}), std::nullopt);
    layout.find(id(3))->place = model::Place::Pocketed;
    EXPECT_EQ(refusal(layout, Zone::Anywhere, {0.3, 0}), std::nullopt);
}

TEST(Placement, NamesThePositionAndTheReason) {
    const auto checked = check_placement(nine_foot(), layout_of({}), Zone::Anywhere, {3, 0.5});
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().detail, "(3, 0.5) m is not inside the cushions");
}

TEST(Spotting, PutsABallOnTheFootSpotWhenItIsFree) {
    EXPECT_EQ(spotted(layout_of({})), kSpot_m);
    EXPECT_EQ(spotted(layout_of({{1, kSpot_m + Vec2{0, kDiameter_m}}})), kSpot_m);
    EXPECT_EQ(spotted(layout_of({{0, kSpot_m - Vec2{kDiameter_m + 0.01, 0}}})), kSpot_m);
}

TEST(Spotting, TouchesTheBallInTheWayFromBehindIt) {
    EXPECT_EQ(spotted(layout_of({{1, kSpot_m}})), (kSpot_m + Vec2{kDiameter_m, 0}));
    const Vec2 aside = spotted(layout_of({{1, kSpot_m + Vec2{0.01, 0.02}}}));
    EXPECT_EQ(aside.y, 0.0);
    EXPECT_GT(aside.x, kSpot_m.x);
    EXPECT_NEAR(glm::distance(aside, kSpot_m + Vec2{0.01, 0.02}), kDiameter_m, 1e-12);
}

TEST(Spotting, FillsTheFirstGapThatIsWideEnough) {
    const double near_m = kSpot_m.x + 1.9 * kDiameter_m;
    const double far_m = kSpot_m.x + 2.0 * kDiameter_m;
    const auto between = [](double second_m) {
        return spotted(layout_of({{1, kSpot_m}, {2, {second_m, 0}}})).x;
    };
    EXPECT_NEAR(between(far_m), kSpot_m.x + kDiameter_m, 1e-12);
    EXPECT_NEAR(between(near_m), near_m + kDiameter_m, 1e-12);
}

TEST(Spotting, NeverTouchesTheCueBall) {
    for (const double offset_m : {0.0, 0.01, -0.01, kDiameter_m, -kDiameter_m}) {
        const Vec2 cue_ball_m = kSpot_m + Vec2{offset_m, 0};
        const double gap_m =
            glm::distance(spotted(layout_of({{0, cue_ball_m}})), cue_ball_m) - kDiameter_m;
        EXPECT_GT(gap_m, 5e-5) << offset_m;
        EXPECT_LT(gap_m, 2e-4) << offset_m;
    }
}

TEST(Spotting, GoesInFrontOfTheSpotWhenEverythingBehindItIsBlocked) {
    std::vector<std::pair<int, Vec2>> row;
    int ball = 1;
    for (double x_m = kSpot_m.x; x_m < nine_foot().half_playing_m.x; x_m += 1.5 * kDiameter_m) {
        row.emplace_back(ball++, Vec2{x_m, 0});
    }
    const Vec2 place_m = spotted(layout_of(row), 15);
    EXPECT_NEAR(place_m.x, kSpot_m.x - kDiameter_m, 1e-12);
}

TEST(Spotting, TakesSeveralBallsInAscendingNumber) {
    model::Layout layout = layout_of({});
    for (const int ball : {3, 5, 9}) {
        layout.balls.push_back({id(ball), model::Place::OffTable, {}});
    }
    spot_balls(nine_foot(), layout, std::vector{id(9), id(3), id(5)});
    EXPECT_EQ(layout.find(id(3))->position_m, kSpot_m);
    EXPECT_NEAR(layout.find(id(5))->position_m.x, kSpot_m.x + kDiameter_m, 1e-12);
    EXPECT_NEAR(layout.find(id(9))->position_m.x, kSpot_m.x + 2 * kDiameter_m, 1e-12);
    for (const int ball : {3, 5, 9}) EXPECT_TRUE(layout.on_table(id(ball)));
}

TEST(DefaultPlacement, IsNearTheHeadSpotAndAlwaysAllowed) {
    const Vec2 spot_m = model::head_spot(nine_foot());
    const Vec2 behind = default_placement(nine_foot(), layout_of({}), Zone::BehindHeadString);
    EXPECT_LT(behind.x, spot_m.x);
    EXPECT_LT(glm::distance(behind, spot_m), 0.002);
    EXPECT_EQ(default_placement(nine_foot(), layout_of({}), Zone::Anywhere), spot_m);
}

TEST(DefaultPlacement, FindsAFreePlaceInEveryRandomLayout) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const model::Layout layout = random_layout(seed);
        for (const Zone zone : {Zone::Anywhere, Zone::BehindHeadString}) {
            const Vec2 place_m = default_placement(nine_foot(), layout, zone);
            EXPECT_EQ(refusal(layout, zone, place_m), std::nullopt) << seed;
        }
    }
}

TEST(DefaultPlacement, LeavesTheLongStringWhenAllOfItIsBlocked) {
    std::vector<std::pair<int, Vec2>> row;
    for (int ball = 1; ball <= 9; ++ball) row.emplace_back(ball, Vec2{-1.27 + 0.08 * ball, 0});
    const model::Layout layout = layout_of(row);
    const Vec2 place_m = default_placement(nine_foot(), layout, Zone::BehindHeadString);
    EXPECT_NE(place_m.y, 0.0);
    EXPECT_EQ(refusal(layout, Zone::BehindHeadString, place_m), std::nullopt);
}

TEST(HeadString, HasTheObjectBallsOnTheTableBehindIt) {
    const double line_m = *nine_foot().head_string_m;
    model::Layout layout = layout_of(
        {{0, {line_m - 0.2, 0}}, {1, {line_m - 0.01, 0}}, {2, {line_m, 0.1}}, {3, {-1, 0.3}}});
    layout.find(id(3))->place = model::Place::Pocketed;
    EXPECT_EQ(balls_behind_head_string(nine_foot(), layout), model::BallSet{id(1)});
}

}  // namespace
}  // namespace billiards::match
