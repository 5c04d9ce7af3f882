// Takes layouts told ball by ball; gives whether exactly the pots that are there are seen.
#include "common/bot/candidates.h"

#include "common/base/elementary.h"
#include "tests/common/match/layouts.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace billiards::bot {
namespace {

using base::Vec2;
using match::id;
using match::kRadius_m;
using match::layout_of;
using match::nine_foot;

constexpr model::PocketId kFootRight{2};
constexpr model::PocketId kFootLeft{3};
constexpr model::PocketId kHeadLeft{5};
constexpr model::PocketId kSideRight{1};

std::vector<Pot> pots(const model::Layout& layout, model::BallSet targets, Vec2 cue_ball_m) {
    return pots_from(nine_foot(), layout, targets, cue_ball_m);
}

bool sees(const std::vector<Pot>& pots, int ball, model::PocketId pocket) {
    return std::ranges::any_of(
        pots, [&](const Pot& pot) { return pot.ball == id(ball) && pot.pocket == pocket; });
}

TEST(Pots, StraightOneIsSeenAimedAtFullAndIsTheEasiest) {
    const model::Layout layout = layout_of({{3, {0.9, -0.265}}});
    const Vec2 cue_ball_m{0.6, 0.035};
    const std::vector<Pot> seen = pots(layout, {id(3)}, cue_ball_m);
    ASSERT_FALSE(seen.empty());
    const Pot& pot = seen.front();
    EXPECT_EQ(pot.pocket, kFootRight);
    EXPECT_GT(pot.cut_cosine, 0.999);
    EXPECT_NEAR(aim_rad(cue_ball_m, pot), -base::kPi / 4, 0.05);
}

TEST(Pots, OnlyTargetsAreSeen) {
    const model::Layout layout = layout_of({{3, {0.9, -0.3}}, {12, {0.9, 0.3}}});
    const std::vector<Pot> seen = pots(layout, {id(12)}, {0.0, 0.0});
    EXPECT_TRUE(sees(seen, 12, kFootLeft));
    EXPECT_FALSE(sees(seen, 3, kFootRight));
}

TEST(Pots, BallThatIsDownIsNotSeen) {
    model::Layout layout = layout_of({{3, {0.9, -0.3}}});
    layout.balls.front().place = model::Place::Pocketed;
    EXPECT_TRUE(pots(layout, {id(3)}, {0.0, 0.0}).empty());
}

TEST(Pots, BlockedOnEitherPathIsNotSeen) {
    const Vec2 ball_m{0.9, -0.265};
    const Vec2 cue_ball_m{0.6, 0.035};
    const auto with = [&](Vec2 blocker_m) {
        return pots(layout_of({{3, ball_m}, {4, blocker_m}}), {id(3)}, cue_ball_m);
    };
    EXPECT_TRUE(sees(with({-0.5, 0.3}), 3, kFootRight)) << "out of the way";
    EXPECT_FALSE(sees(with((ball_m + cue_ball_m) / 2.0), 3, kFootRight)) << "before the ball";
    EXPECT_FALSE(sees(with(ball_m + Vec2{0.15, -0.15}), 3, kFootRight)) << "before the pocket";
}

TEST(Pots, BackwardsCutIsNotSeen) {
    const model::Layout layout = layout_of({{3, {0.5, 0.0}}});
    const std::vector<Pot> seen = pots(layout, {id(3)}, {0.9, 0.0});
    EXPECT_FALSE(sees(seen, 3, kFootRight));
    EXPECT_FALSE(sees(seen, 3, kFootLeft));
}

TEST(Pots, SidePocketIsSeenFromInFrontAndNotAlongTheRail) {
    EXPECT_TRUE(sees(pots(layout_of({{3, {0.0, -0.3}}}), {id(3)}, {0.0, 0.1}), 3, kSideRight));
    EXPECT_FALSE(sees(pots(layout_of({{3, {0.7, -0.58}}}), {id(3)}, {1.1, -0.5}), 3, kSideRight));
}

TEST(Pots, BallThatHangsInTheJawsIsSeenIntoItsPocket) {
    const model::Layout layout = layout_of({{3, {-1.2535, 0.6019}}});
    EXPECT_TRUE(sees(pots(layout, {id(3)}, {0.0, 0.0}), 3, kHeadLeft));
}

TEST(Pots, EasierMeansNearerAndFuller) {
    const auto margin = [&](Vec2 ball_m, Vec2 cue_ball_m) {
        for (const Pot& pot : pots(layout_of({{3, ball_m}}), {id(3)}, cue_ball_m)) {
            if (pot.pocket == kSideRight) return pot.margin_rad;
        }
        return 0.0;
    };
    const double plain = margin({0.0, -0.2}, {0.0, 0.2});
    EXPECT_GT(plain, margin({0.0, 0.0}, {0.0, 0.4})) << "further from the pocket";
    EXPECT_GT(plain, margin({0.0, -0.2}, {0.0, 0.5})) << "further from the cue ball";
    EXPECT_GT(plain, margin({0.0, -0.2}, {0.28, 0.08})) << "thinner";
}

TEST(StraightInPlaces, SeeTheirPotFull) {
    const model::Layout layout = layout_of({{3, {0.4, 0.1}}});
    const std::vector<Vec2> places_m = straight_in_places(nine_foot(), layout, {id(3)});
    ASSERT_FALSE(places_m.empty());
    for (const Vec2 place_m : places_m) {
        const std::vector<Pot> seen = pots(layout, {id(3)}, place_m);
        const bool full =
            std::ranges::any_of(seen, [](const Pot& pot) { return pot.cut_cosine > 1 - 1e-9; });
        EXPECT_TRUE(full) << place_m.x << ", " << place_m.y;
    }
}

TEST(ClearPath, IsABallsWidthWide) {
    const model::Layout layout = layout_of({{3, {0.0, 0.05}}});
    EXPECT_FALSE(is_path_clear(layout, {-1, 0}, {1, 0}, id(9)));
    EXPECT_TRUE(is_path_clear(layout, {-1, 0}, {1, 0}, id(3))) << "the ball that may be met";
    EXPECT_TRUE(is_path_clear(layout, {-1, 0}, {-0.1, 0}, id(9))) << "ends before it";
    const double touching_m = 0.05 - 2 * kRadius_m;
    EXPECT_TRUE(is_path_clear(layout, {-1, touching_m}, {1, touching_m}, id(9)));
}

}  // namespace
}  // namespace billiards::bot
