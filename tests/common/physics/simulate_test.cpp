// Holds whole shots on the named tables: what is pocketed, met, crossed, and named in the record.
#include "tests/common/physics/still_life.h"

namespace billiards::physics {
namespace {

TEST(Simulate, PocketsAStraightShotIntoEachPocketOfEachTable) {
    for (const auto size :
         {model::TableSize::SevenFoot, model::TableSize::EightFoot, model::TableSize::NineFoot}) {
        const auto& table = model::table_of(size);
        for (std::size_t pocket = 0; pocket < table.pockets.size(); ++pocket) {
            const Vec2 start{0.1 * table.pockets[pocket].center_m.x, 0.0};
            const Vec2 way = glm::normalize(table.pockets[pocket].center_m - start);
            const auto record = solved(table, {}, {ball_at(1, start, 2.5 * way)});
            const auto pocketed = events_of(record, EventKind::Pocketed);
            ASSERT_EQ(pocketed.size(), 1U) << "pocket " << pocket;
            EXPECT_EQ(pocketed[0].index, pocket);
            EXPECT_TRUE(events_of(record, EventKind::Cushion).empty());
            EXPECT_TRUE(events_of(record, EventKind::Jaw).empty());
            const auto& placed = record.final_layout.balls.at(0);
            EXPECT_EQ(placed.place, model::Place::Pocketed);
            EXPECT_NEAR(glm::distance(placed.position_m, table.pockets[pocket].center_m),
                        table.pockets[pocket].radius_m, 1e-12)
                << "where it fell";
            EXPECT_EQ(state_of(record, 1, 100.0).velocity_mps, Vec3{});
        }
    }
}

TEST(Simulate, ABallAtAJawRattlesOrTurnsAway) {
    const auto& table = nine_foot();
    const model::JawArc& jaw = table.jaws.at(2);
    const Vec2 start{jaw.center_m.x, 0.0};
    const auto record =
        solved(table, {}, {ball_at(1, start, {0, table.jaws[2].center_m.y > 0 ? 2.0 : -2.0})});
    const auto hits = events_of(record, EventKind::Jaw);
    ASSERT_FALSE(hits.empty());
    EXPECT_EQ(hits[0].index, 2U);
    EXPECT_FALSE(hits[0].held);
    const Vec3 place = state_of(record, 1, hits[0].time_s).position_m;
    EXPECT_NEAR(glm::distance(base::horizontal(place), jaw.center_m), jaw.radius_m + kRadius_m,
                1e-12);
}

TEST(Simulate, ABareEndOfASegmentIsAnArcOfRadiusZero) {
    model::TableSpec table;
    table.cushions = {{{0.5, 0.0}, {0.5, 1.0}}};
    table.jaws = {{{9.0, 9.0}, 0.1}};
    table.nose_height_m = 0.635 * 2 * kRadius_m;
    const auto record = solved(table, {}, {ball_at(1, {0, -0.01}, {2, 0})});
    const auto hit = events_of(record, EventKind::Jaw).at(0);
    EXPECT_EQ(hit.index, 1U) << "after the table's own arcs";
    const Vec3 place = state_of(record, 1, hit.time_s).position_m;
    EXPECT_NEAR(glm::distance(base::horizontal(place), Vec2(0.5, 0.0)), kRadius_m, 1e-12);
}

TEST(Simulate, SegmentsStopABallFromEitherSide) {
    model::TableSpec table;
    table.cushions = {{{0.0, -1.0}, {0.0, 1.0}}};
    table.nose_height_m = 0.635 * 2 * kRadius_m;
    for (const double side : {1.0, -1.0}) {
        const auto record = solved(table, {}, {ball_at(1, {side * 0.4, 0.2}, {-side, 0})});
        const auto hit = events_of(record, EventKind::Cushion).at(0);
        EXPECT_NEAR(state_of(record, 1, hit.time_s).position_m.x, side * kRadius_m, 1e-14);
        EXPECT_GT(side * state_of(record, 1, hit.time_s).velocity_mps.x, 0.0);
    }
}

TEST(Simulate, TurnsBackABallsRadiusFromTheCushion) {
    const auto record = solved(nine_foot(), {}, {ball_at(1, {0.2, 0.1}, {2.0, 0.0})});
    const auto hit = events_of(record, EventKind::Cushion).at(0);
    EXPECT_NEAR(state_of(record, 1, hit.time_s).position_m.x,
                nine_foot().half_playing_m.x - kRadius_m, 1e-14);
}

TEST(Simulate, TellsWhenTheCueBallCrossesTheHeadString) {
    const double line = *nine_foot().head_string_m;
    const auto there_and_back =
        solved(nine_foot(), {},
               {ball_at(0, {line - 0.2, 0.3}, {6, 0}), ball_at(1, {line - 0.2, -0.3}, {3, 0})});
    const auto crossings = events_of(there_and_back, EventKind::HeadString);
    ASSERT_GE(crossings.size(), 2U);
    EXPECT_EQ(crossings[0].direction, 1);
    EXPECT_EQ(crossings[1].direction, -1);
    for (const auto& crossing : crossings) {
        EXPECT_EQ(crossing.ball, model::kCueBall);
        EXPECT_NEAR(state_of(there_and_back, 0, crossing.time_s).position_m.x, line, 1e-12);
    }
}

TEST(Simulate, ABallOnTheHeadStringIsNotBehindIt) {
    const double line = *nine_foot().head_string_m;
    const auto onward = solved(nine_foot(), {}, {ball_at(0, {line, 0.1}, {0.5, 0})});
    EXPECT_TRUE(events_of(onward, EventKind::HeadString).empty());
    const auto back = solved(nine_foot(), {}, {ball_at(0, {line, 0.1}, {-0.5, 0})});
    EXPECT_EQ(events_of(back, EventKind::HeadString).at(0).direction, -1);
}

TEST(Simulate, ARealContactAfterAHeldOneIsNotHeld) {
    // Frozen to the long cushion, driven along and into it, then across the table and back.
    const double y = nine_foot().half_playing_m.y - kRadius_m;
    const auto record = solved(nine_foot(), {}, {ball_at(1, {0.3, y}, {0.5, 3.0})});
    const auto contacts = events_of(record, EventKind::Cushion);
    ASSERT_GE(contacts.size(), 2U);
    EXPECT_TRUE(contacts[0].held);
    EXPECT_FALSE(contacts[1].held);
}

TEST(Simulate, AJumpShotClearsABallInItsWay) {
    model::Layout layout{{{.ball = model::kCueBall, .position_m = {-0.8, 0}},
                          {.ball = BallId{1}, .position_m = {-0.45, 0}}}};
    const model::Shot level{.power = 0.6};
    const model::Shot jump{.power = 0.6, .elevation_rad = base::radians(40)};
    const auto hit = simulate_shot(nine_foot(), {}, layout, level);
    const auto cleared = simulate_shot(nine_foot(), {}, layout, jump);
    ASSERT_TRUE(hit.ok() && cleared.ok());
    EXPECT_LT(events_of(*hit, EventKind::BallBall).at(0).time_s, 0.2);
    const auto contacts = events_of(*cleared, EventKind::BallBall);
    EXPECT_TRUE(contacts.empty() || contacts[0].time_s > 0.2);
    EXPECT_EQ(track_of(*cleared, 0).segments.front().motion, Motion::Airborne);
}

TEST(Simulate, ABallThatFliesOverTheRailIsOffTheTable) {
    BallStart ball = ball_at(1, {1.0, 0.1}, {3, 0});
    ball.velocity_mps.z = 2.0;
    const auto record = solved(nine_foot(), {}, {ball});
    EXPECT_EQ(events_of(record, EventKind::OffTable).size(), 1U);
    EXPECT_EQ(record.final_layout.balls[0].place, model::Place::OffTable);
}

TEST(Simulate, ABallThatComesDownOnTheCornerOfTheRailsIsOffTheTable) {
    // Beyond the facings' ends, where no nose is beside it, and out of the pocket's reach.
    const Vec2 corner = nine_foot().half_playing_m;
    BallStart ball = ball_at(1, corner - Vec2{0.4, 0.6});
    ball.position_m.z += 0.6;
    const double fall_s = std::sqrt(2 * 0.6 / Parameters{}.gravity_mps2);
    ball.velocity_mps = Vec3{Vec2{0.52, 0.52} / fall_s, 0.0};
    const auto record = solved(nine_foot(), {}, {ball});
    EXPECT_EQ(events_of(record, EventKind::OffTable).size(), 1U);
    EXPECT_TRUE(events_of(record, EventKind::Landing).empty());
}

TEST(Simulate, AnAirborneBallMeetsTheNoseByItsTrueHeight) {
    BallStart low = ball_at(1, {1.0, 0.1}, {3, 0});
    low.velocity_mps.z = 0.3;
    const auto record = solved(nine_foot(), {}, {low});
    EXPECT_TRUE(events_of(record, EventKind::OffTable).empty());
    EXPECT_FALSE(events_of(record, EventKind::Cushion).empty());
}

TEST(Simulate, ABallThatRollsPastATablesEdgeIsOffIt) {
    model::TableSpec table;
    table.half_outer_m = {0.5, 0.5};
    const auto record = solved(table, {}, {ball_at(1, {0, 0}, {2, 0})});
    const auto off = events_of(record, EventKind::OffTable).at(0);
    EXPECT_NEAR(state_of(record, 1, off.time_s).position_m.x, 0.5, 1e-12);
}

TEST(Simulate, NamesEveryBallOfTheLayout) {
    model::Layout layout{
        {{.ball = model::kCueBall, .position_m = {-0.5, 0}},
         {.ball = BallId{3}, .place = model::Place::Pocketed, .position_m = {1.3, 0.6}},
         {.ball = BallId{5}, .position_m = {0.5, 0}}}};
    const auto record = simulate_shot(nine_foot(), {}, layout, {.power = 0.2});
    ASSERT_TRUE(record.ok());
    ASSERT_EQ(record->final_layout.balls.size(), 3U);
    EXPECT_EQ(*record->final_layout.find(BallId{3}), layout.balls[1]);
    EXPECT_EQ(record->hash, timeline::hash_of(*record));
    EXPECT_EQ(state_of(*record, 3, 0.0).motion, Motion::Pocketed);
}

TEST(Simulate, NeedsACueBallToStrike) {
    const model::Layout layout{{{.ball = model::kCueBall, .place = model::Place::InHand},
                                {.ball = BallId{1}, .position_m = {0, 0}}}};
    const auto record = simulate_shot(nine_foot(), {}, layout, {});
    ASSERT_FALSE(record.ok());
    EXPECT_EQ(record.error().code, ErrorCode::NoCueBall);
}

TEST(Simulate, EndlessShotsAreRefusedByTheirNumberOfEvents) {
    // No friction at all: the ball crosses the table for ever.
    Parameters ice;
    ice.sliding_friction = ice.rolling_friction = 0.0;
    ice.cushion = CushionModel::Mirror;
    ice.cushion_restitution = 1.0;
    const auto record = simulate(nine_foot(), ice, std::vector{ball_at(1, {0, 0.1}, {2, 0})});
    ASSERT_FALSE(record.ok());
    EXPECT_EQ(record.error().code, ErrorCode::Unsolvable);
}

}  // namespace
}  // namespace billiards::physics
