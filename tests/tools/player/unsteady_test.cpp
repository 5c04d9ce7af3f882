// Holds the unsteady hand to what it may change.
#include "tools/player/unsteady.h"

#include <gtest/gtest.h>
#include <variant>

namespace billiards::tools {
namespace {

match::Command straight_ahead(const match::MatchState&, base::Random&) {
    return match::TakeShot{.turn = {}, .shot = {.angle_rad = 1.0, .power = 0.3}, .call = {}};
}

TEST(Unsteady, TurnsEachShotWithinItsError) {
    base::Random random(1);
    const Choose choose = unsteady(straight_ahead, 0.01);
    bool went_left = false;
    bool went_right = false;
    for (int i = 0; i < 100; ++i) {
        const model::Shot shot = std::get<match::TakeShot>(choose({}, random)).shot;
        EXPECT_NEAR(shot.angle_rad, 1.0, 0.01);
        EXPECT_EQ(shot.power, 0.3);
        went_left |= shot.angle_rad > 1.005;
        went_right |= shot.angle_rad < 0.995;
    }
    EXPECT_TRUE(went_left && went_right);
}

TEST(Unsteady, LeavesEverythingButShotsAlone) {
    base::Random random(1);
    const match::Command placement = match::PlaceCueBall{{0.1, 0.2}};
    const Choose choose =
        unsteady([&](const match::MatchState&, base::Random&) { return placement; }, 0.01);
    EXPECT_EQ(choose({}, random), placement);
}

}  // namespace
}  // namespace billiards::tools
