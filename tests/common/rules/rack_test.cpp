// Takes seeds; gives whether every game but eight-ball racks the right balls in their places and
// the others anywhere.
#include "common/model/rack.h"

#include "common/rules/ruleset.h"
#include "tests/common/rules/told_shot.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace billiards::rules {
namespace {

using base::Vec2;

constexpr double kRadius_m = model::BallSpec{}.radius_m;

const model::TableSpec& nine_foot() {
    return model::table_of(model::TableSize::NineFoot);
}

model::Layout racked(Game game, std::uint64_t seed, const Options& options = {}) {
    base::Random random(seed);
    return ruleset_of(game).rack(options, nine_foot(), kRadius_m, random);
}

Vec2 place_of(const model::Layout& layout, int ball) {
    return layout.find(ToldShot::id(ball))->position_m;
}

void expect_filled(const model::Layout& layout, const std::vector<Vec2>& places) {
    ASSERT_EQ(layout.balls.size(), places.size() + 1);
    EXPECT_EQ(layout.balls[0], (model::PlacedBall{model::kCueBall, model::Place::InHand, {}}));
    for (std::size_t i = 1; i < layout.balls.size(); ++i) {
        EXPECT_EQ(layout.balls[i].ball.number, i);
        EXPECT_EQ(layout.balls[i].place, model::Place::OnTable);
    }
    for (const Vec2& place : places) {
        EXPECT_EQ(std::ranges::count(layout.balls, place, &model::PlacedBall::position_m), 1);
    }
}

/// The places at which a ball is seen over many seeds.
std::size_t places_of(Game game, int ball) {
    std::set<std::pair<double, double>> seen;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Vec2 place = place_of(racked(game, seed), ball);
        seen.insert({place.x, place.y});
    }
    return seen.size();
}

TEST(NineBallRack, IsADiamondWithTheOneAtTheApexAndTheNineInTheMiddle) {
    const std::vector<Vec2> places = model::diamond_positions(nine_foot(), kRadius_m);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const model::Layout layout = racked(Game::NineBall, seed);
        expect_filled(layout, places);
        EXPECT_EQ(place_of(layout, 1), places[0]);
        EXPECT_EQ(place_of(layout, 9), places[model::kMiddlePlace]);
    }
}

TEST(NineBallRack, HasTheNineOnTheFootSpotWhereTheOptionSaysSo) {
    const model::Layout layout = racked(Game::NineBall, 1, {.nine_on_foot_spot = true});
    EXPECT_EQ(place_of(layout, 9), model::foot_spot(nine_foot()));
    EXPECT_LT(place_of(layout, 1).x, place_of(layout, 9).x);
    EXPECT_EQ(place_of(layout, 1).y, 0.0);
    EXPECT_EQ(place_of(racked(Game::NineBall, 1), 1), model::foot_spot(nine_foot()));
}

TEST(NineBallRack, HasTheOtherBallsAtEveryOtherPlace) {
    EXPECT_EQ(places_of(Game::NineBall, 2), 7U);
    EXPECT_EQ(places_of(Game::NineBall, 8), 7U);
}

TEST(TenBallRack, IsATriangleWithTheOneOnTheFootSpotAndTheTenInTheMiddle) {
    const std::vector<Vec2> places = model::triangle_positions(nine_foot(), kRadius_m, 4);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const model::Layout layout = racked(Game::TenBall, seed);
        expect_filled(layout, places);
        EXPECT_EQ(place_of(layout, 1), model::foot_spot(nine_foot()));
        EXPECT_EQ(place_of(layout, 10), places[model::kMiddlePlace]);
    }
}

TEST(TenBallRack, HasTheOtherBallsAtEveryOtherPlace) {
    EXPECT_EQ(places_of(Game::TenBall, 2), 8U);
    EXPECT_EQ(places_of(Game::TenBall, 9), 8U);
}

TEST(StraightPoolRack, IsATriangleOfFifteenWithEveryBallAtEveryPlace) {
    expect_filled(racked(Game::StraightPool, 1), model::triangle_positions(nine_foot(), kRadius_m));
    for (const int ball : {1, 8, 15}) EXPECT_EQ(places_of(Game::StraightPool, ball), 15U) << ball;
}

TEST(PracticeRack, IsThatOfEightBall) {
    EXPECT_EQ(racked(Game::Practice, 5), racked(Game::EightBall, 5));
}

}  // namespace
}  // namespace billiards::rules
