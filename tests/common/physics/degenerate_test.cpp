// Holds layouts in which balls touch, line up or balance exactly: where tolerances would decide.
#include "tests/common/physics/soundness.h"
#include "tests/common/physics/still_life.h"

namespace billiards::physics {
namespace {

constexpr double kDiameter_m = 2 * kRadius_m;

Parameters elastic() {
    Parameters parameters;
    parameters.ball_ball = BallBallModel::Elastic;
    return parameters;
}

timeline::ShotRecord sound(const model::TableSpec& table, const std::vector<BallStart>& balls) {
    Diagnostics diagnostics;
    const auto record = solved(table, {}, balls, &diagnostics);
    EXPECT_EQ(first_fault({table, {}, balls, record, diagnostics}), std::nullopt);
    return record;
}

double speed_x(const timeline::ShotRecord& record, int ball, double time_s) {
    return state_of(record, ball, time_s).velocity_mps.x;
}

TEST(Degenerate, AStraightFollowStaysOnItsLineToTheBit) {
    for (const double spin : {1.0, -1.0}) {
        const Vec2 v{2.0, 0.0};
        const auto record = sound(
            nine_foot(), {ball_at(0, {-0.4, 0.0}, v, spin * rolling_spin(v)), ball_at(1, {0, 0})});
        for (const int ball : {0, 1}) {
            for (const auto& segment : track_of(record, ball).segments) {
                EXPECT_EQ(segment.position_m.y, 0.0);
                EXPECT_EQ(segment.velocity_mps.y, 0.0);
            }
        }
    }
}

TEST(Degenerate, ACradleOfLossyBallsPartsInOrderAndKeepsItsMomentum) {
    for (int count = 2; count <= 7; ++count) {
        std::vector<BallStart> balls{ball_at(0, {-kDiameter_m, 0}, {2, 0})};
        for (int i = 1; i <= count; ++i) balls.push_back(ball_at(i, {(i - 1) * kDiameter_m, 0}));
        const auto record = solved(model::open_table(), {}, balls);
        double momentum = 0.0;
        for (int i = 0; i <= count; ++i) {
            momentum += speed_x(record, i, 0.0);
            if (i == 0) continue;
            EXPECT_GE(speed_x(record, i, 0.0), speed_x(record, i - 1, 0.0) - 1e-12);
        }
        EXPECT_NEAR(momentum, 2.0, 1e-12);
        EXPECT_GT(speed_x(record, count, 0.0), 1.6) << "most of it goes to the last";
    }
}

TEST(Degenerate, TwentyTwoFrozenBallsInARowPassABlowThrough) {
    std::vector<BallStart> balls{ball_at(0, {-0.7, 0}, {4, 0}, rolling_spin({4, 0}))};
    for (int i = 1; i < 22; ++i) balls.push_back(ball_at(i, {-0.6 + (i - 1) * kDiameter_m, 0}));
    for (const Parameters& parameters : {realistic_parameters(), elastic()}) {
        const auto record = solved(nine_foot(), parameters, balls);
        const double hit_s = events_of(record, EventKind::BallBall).at(0).time_s;
        const double arriving = speed_x(record, 0, std::nextafter(hit_s, 0.0));
        double momentum = 0.0;
        for (int i = 0; i < 22; ++i) momentum += speed_x(record, i, hit_s);
        EXPECT_NEAR(momentum, arriving, 1e-11);
    }
}

TEST(Degenerate, BallsThatArriveFromBothSidesAtOnceLeaveTheThirdWhereItLies) {
    for (const Parameters& parameters : {realistic_parameters(), elastic()}) {
        const auto record = solved(
            model::open_table(), parameters,
            {ball_at(0, {-0.5, 0}, {2, 0}), ball_at(1, {0, 0}), ball_at(2, {0.5, 0}, {-2, 0})});
        const auto hits = events_of(record, EventKind::BallBall);
        ASSERT_EQ(hits.size(), 2U);
        EXPECT_EQ(hits[0].time_s, hits[1].time_s);
        EXPECT_EQ(record.final_layout.find(BallId{1})->position_m, Vec2(0, 0));
        EXPECT_EQ(record.final_layout.find(BallId{0})->position_m,
                  -record.final_layout.find(BallId{2})->position_m);
    }
}

model::TableSpec box() {
    model::TableSpec table;
    table.cushions = {{{-1, -0.5}, {1, -0.5}},
                      {{1, -0.5}, {1, 0.5}},
                      {{1, 0.5}, {-1, 0.5}},
                      {{-1, 0.5}, {-1, -0.5}}};
    table.nose_height_m = 0.635 * kDiameter_m;
    return table;
}

TEST(Degenerate, AShotIntoTheExactCornerComesBackAlongItsWay) {
    const Vec2 corner{1 - kRadius_m, 0.5 - kRadius_m};
    const auto record = solved(box(), {}, {ball_at(0, corner - 0.25, {2, 2})});
    const auto hits = events_of(record, EventKind::Cushion);
    ASSERT_GE(hits.size(), 2U);
    EXPECT_EQ(hits[0].time_s, hits[1].time_s);
    const Vec3 after = state_of(record, 0, hits[0].time_s).velocity_mps;
    EXPECT_NEAR(after.x, after.y, 1e-12);
    EXPECT_LT(after.x, -0.5);
    const auto frozen = solved(box(), {}, {ball_at(0, corner, {2, 1})});
    EXPECT_EQ(events_of(frozen, EventKind::Cushion).at(1).time_s, 0.0) << "both at once";
    EXPECT_LT(state_of(frozen, 0, 0.0).velocity_mps.x, 0.0);
    EXPECT_LT(state_of(frozen, 0, 0.0).velocity_mps.y, 0.0);
}

TEST(Degenerate, WhereTwoSegmentsOfOneLineMeetABallMeetsOneCushion) {
    model::TableSpec whole = box();
    model::TableSpec parted = box();
    parted.cushions[2] = {{1, 0.5}, {0, 0.5}};
    parted.cushions.push_back({{0, 0.5}, {-1, 0.5}});
    const std::vector balls{ball_at(0, {0, 0.2}, {0, 2}, {0, 0, 50})};
    const auto expected = solved(whole, {}, balls);
    const auto found = solved(parted, {}, balls);
    EXPECT_EQ(track_of(found, 0).segments, track_of(expected, 0).segments);
    EXPECT_EQ(found.events, expected.events);
}

TEST(Degenerate, TheRoundedEndOfACushionIsNoNewContactForABallFrozenToIt) {
    const double y = nine_foot().half_playing_m.y - kRadius_m;
    for (const double x : {0.3, -0.3}) {
        const auto record = sound(nine_foot(), {ball_at(1, {x, y}, {1.0, 0.0})});
        const auto contacts = events_of(record, EventKind::Jaw);
        if (!contacts.empty()) {
            EXPECT_TRUE(contacts[0].held);
        }
    }
}

TEST(Degenerate, ABallDroppedExactlyOnTopOfAnotherFallsOffTowardsTheTablesCentre) {
    for (const double height : {1e-4, 0.01, 0.3}) {
        BallStart above = ball_at(0, {0.4, -0.3});
        above.position_m.z += kDiameter_m + height;
        const auto record = sound(nine_foot(), {above, ball_at(1, {0.4, -0.3})});
        const Vec3 start = track_of(record, 0).segments.front().position_m;
        for (const auto& segment : track_of(record, 0).segments) {
            if (events_of(record, EventKind::Landing).at(0).time_s < segment.start_s) break;
            EXPECT_LE(segment.position_m.x, start.x);
            EXPECT_GE(segment.position_m.y, start.y);
        }
        EXPECT_EQ(state_of(record, 0, record.duration_s).motion, Motion::Resting);
    }
}

TEST(Degenerate, ABallOnThePocketsLipStaysUntilItIsTouched) {
    const model::PocketCircle& side = nine_foot().pockets[1];
    const BallStart lip = ball_at(1, side.center_m + Vec2{0, side.radius_m + 1e-12});
    EXPECT_TRUE(solved(nine_foot(), {}, {lip}).events.empty());
    const auto record = solved(
        nine_foot(), {},
        {ball_at(0, base::horizontal(lip.position_m) + Vec2{0, kDiameter_m + 0.01}, {0, -0.1}),
         lip});
    const auto pocketed = events_of(record, EventKind::Pocketed);
    ASSERT_GE(pocketed.size(), 1U);
    EXPECT_EQ(pocketed[0].ball, BallId{1});
}

TEST(Degenerate, ABallThatRestsAgainstAJawStaysAndIsHeldThereWhenItIsHit) {
    const model::JawArc& jaw = nine_foot().jaws.at(2);
    const Vec2 away = glm::normalize(Vec2{-0.6, 0.8});
    const Vec2 place = jaw.center_m + (jaw.radius_m + kRadius_m) * away;
    EXPECT_TRUE(solved(nine_foot(), {}, {ball_at(1, place)}).events.empty());
    const auto record = sound(
        nine_foot(), {ball_at(0, place + (kDiameter_m + 0.1) * away, -away), ball_at(1, place)});
    const auto hits = events_of(record, EventKind::Jaw);
    ASSERT_GE(hits.size(), 1U);
    EXPECT_TRUE(hits[0].held);
    EXPECT_GT(glm::dot(base::horizontal(state_of(record, 1, hits[0].time_s).velocity_mps), away),
              -1e-9);
}

TEST(Degenerate, SpinAboutTheVerticalAloneMovesNoTouchingBall) {
    const auto record =
        sound(nine_foot(), {ball_at(0, {0, 0}, {}, {0, 0, 200}), ball_at(1, {kDiameter_m, 0}),
                            ball_at(2, {0, kDiameter_m})});
    EXPECT_TRUE(events_of(record, EventKind::BallBall).empty());
    EXPECT_NEAR(record.duration_s, 200 / Parameters{}.spin_deceleration_radps2, 1e-12);
}

TEST(Degenerate, FollowPushesATouchingBallAndDrawLeavesItAlone) {
    const auto follow =
        sound(nine_foot(), {ball_at(0, {0, 0}, {}, {0, 100, 0}), ball_at(1, {kDiameter_m, 0})});
    EXPECT_GT(follow.final_layout.find(BallId{1})->position_m.x, kDiameter_m + 0.1);
    const auto draw =
        sound(nine_foot(), {ball_at(0, {0, 0}, {}, {0, -100, 0}), ball_at(1, {kDiameter_m, 0})});
    EXPECT_EQ(draw.final_layout.find(BallId{1})->position_m, Vec2(kDiameter_m, 0));
    EXPECT_TRUE(events_of(draw, EventKind::BallBall).empty());
}

TEST(Degenerate, TouchingBallsThatRollAlikeDoNotMeet) {
    const Vec2 v{0.4, 0.0};
    for (const Vec2& offset : {Vec2{0, kDiameter_m}, Vec2{kDiameter_m, 0}}) {
        const auto record = sound(nine_foot(), {ball_at(0, {0, 0}, v, rolling_spin(v)),
                                                ball_at(1, offset, v, rolling_spin(v))});
        EXPECT_TRUE(events_of(record, EventKind::BallBall).empty());
        const Vec2 apart = record.final_layout.find(BallId{1})->position_m -
                           record.final_layout.find(BallId{0})->position_m;
        EXPECT_NEAR(glm::distance(apart, offset), 0.0, 1e-12);
    }
}

}  // namespace
}  // namespace billiards::physics
