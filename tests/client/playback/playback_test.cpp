// Holds the playback of a shot against its record, and a break against itself a moment later.
#include "client/playback/playback.h"

#include "common/match/match.h"
#include "common/physics/simulate.h"
#include "common/protocol/codec.h"
#include "common/protocol/limits.h"
#include "tests/client/app/told.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace billiards::client {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr base::Duration kOffset = seconds(40);
constexpr base::Instant kStruck{seconds(60)};  // On the local clock; 100 s on the server's.

/// A break as it comes over the wire.
protocol::server::ShotPlayed a_break() {
    const match::MatchState state = match::start({}, 7).value();
    const model::TableSpec& table = model::table_of(state.settings.table);
    model::Layout layout = state.layout;
    *layout.find(model::kCueBall) = {.ball = model::kCueBall,
                                     .place = model::Place::OnTable,
                                     .position_m = model::head_spot(table)};
    protocol::server::ShotPlayed shot = told::shot(1, told::match_at(2, model::Seat::Second, 1));
    shot.struck_us = (kStruck + kOffset).time_since_epoch().count();
    shot.record = physics::simulate_shot(table, match::parameters_of(state.settings.physics),
                                         layout, {.angle_rad = 0.005, .power = 0.9})
                      .value();
    const protocol::SharedFrame frame = protocol::encode(protocol::ServerMessage(shot));
    const auto sent =
        protocol::decode_server(std::span(*frame).subspan(protocol::kFrameHeaderBytes));
    return std::get<protocol::server::ShotPlayed>(sent.value());
}

const Playback& break_playback() {
    static const Playback playback(a_break(), kOffset);
    return playback;
}

TEST(Playback, BeforeTheStrikeTheBallsAreAsTheyLay) {
    const Playback& playback = break_playback();
    EXPECT_EQ(playback.balls(kStruck - seconds(5)), playback.balls(kStruck));
    EXPECT_EQ(playback.balls(kStruck).size(), 16U);
    EXPECT_TRUE(playback.events_between(kStruck - seconds(5), kStruck - seconds(1)).empty());
}

TEST(Playback, AtItsEndTheBallsAreWhereTheRecordSays) {
    const Playback& playback = break_playback();
    EXPECT_FALSE(playback.finished(playback.ends_at() - milliseconds(1)));
    EXPECT_TRUE(playback.finished(playback.ends_at()));
    for (const ShownBall& shown : playback.balls(playback.ends_at())) {
        const model::PlacedBall* placed = playback.shot().record.final_layout.find(shown.ball);
        ASSERT_NE(placed, nullptr);
        EXPECT_EQ(model::is_on_table(shown.state.motion), placed->place == model::Place::OnTable);
        EXPECT_LT(glm::distance(base::horizontal(shown.state.position_m), placed->position_m), 1e-5)
            << int{shown.ball.number};
        EXPECT_LT(glm::length(shown.state.velocity_mps), 1e-4);
    }
}

TEST(Playback, NoBallJumps) {
    const Playback& playback = break_playback();
    constexpr double kFastest_mps = 15.0;  // A full-power break is 11.8 m/s.
    std::vector<ShownBall> before = playback.balls(kStruck);
    for (base::Instant at = kStruck; at < playback.ends_at(); at += milliseconds(1)) {
        const std::vector<ShownBall> now = playback.balls(at);
        for (std::size_t i = 0; i < now.size(); ++i) {
            ASSERT_LT(glm::distance(now[i].state.position_m, before[i].state.position_m),
                      kFastest_mps * 1e-3 + 1e-5)
                << "ball " << int{now[i].ball.number};
        }
        before = now;
    }
}

TEST(Playback, BallsNeverShareAPlaceOnTheScreen) {
    const Playback& playback = break_playback();
    constexpr double kTolerance_m = 1e-5;  // What 32 bits leave of a metre, a few times over.
    for (base::Instant at = kStruck; at < playback.ends_at(); at += milliseconds(1)) {
        const std::vector<ShownBall> balls = playback.balls(at);
        for (std::size_t a = 0; a < balls.size(); ++a) {
            for (std::size_t b = a + 1; b < balls.size(); ++b) {
                if (!model::is_on_table(balls[a].state.motion)) continue;
                if (!model::is_on_table(balls[b].state.motion)) continue;
                ASSERT_GT(glm::distance(balls[a].state.position_m, balls[b].state.position_m),
                          balls[a].radius_m + balls[b].radius_m - kTolerance_m);
            }
        }
    }
}

TEST(Playback, PlayingOnGivesEachEventOnce) {
    const Playback& playback = break_playback();
    std::vector<model::ShotEvent> heard;
    base::Instant before = kStruck - seconds(1);
    for (base::Instant at = kStruck; before < playback.ends_at(); at += milliseconds(16)) {
        const auto events = playback.events_between(before, at);
        heard.insert(heard.end(), events.begin(), events.end());
        before = at;
    }
    EXPECT_EQ(heard, playback.shot().record.events);
    EXPECT_FALSE(heard.empty());
}

TEST(Playback, TimeThatGoesBackGivesNoEvent) {
    EXPECT_TRUE(break_playback().events_between(kStruck + seconds(2), kStruck).empty());
}

}  // namespace
}  // namespace billiards::client
