// Takes told messages and times; gives whether the screen shows each thing when it should.
#include "client/play/presentation.h"

#include "client/app/reduce.h"
#include "tests/client/app/told.h"

#include <chrono>
#include <gtest/gtest.h>

namespace billiards::client {
namespace {

using model::Seat;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// A client that was told messages, with a server's clock like its own.
class PresentationTest : public testing::Test {
  protected:
    void tell(const protocol::ServerMessage& message) {
        const std::optional<TableView> before = state_.table;
        state_ = reduce(std::move(state_), message, told::kNow);
        if (std::holds_alternative<protocol::server::TableSnapshot>(message)) {
            shown_.enter(*state_.table, {});
        } else {
            shown_.received(*before, *state_.table, message, {});
        }
    }

    /// The cue ball rolls a metre in two seconds, struck at kNow.
    static protocol::server::ShotPlayed rolling_shot(std::uint64_t sequence, std::uint32_t turn) {
        auto shot = told::shot(sequence, told::match_at(turn, Seat::Second, 1));
        shot.struck_us = told::kNow.time_since_epoch().count();
        shot.record.duration_s = 2.0;
        timeline::BallTrack track;
        track.ball = model::kCueBall;
        track.radius_m = 0.028575;
        timeline::Segment segment;
        segment.motion = model::Motion::Rolling;
        segment.velocity_mps = {0.5, 0.0, 0.0};
        track.segments = {segment};
        shot.record.timeline.tracks = {track};
        return shot;
    }

    double cue_ball_x(base::Instant now) const {
        return shown_.balls(now).front().state.position_m.x;
    }

    ClientState state_;
    Presentation shown_;
};

TEST_F(PresentationTest, ShowsTheBallsThatLieOnTheTable) {
    tell(told::snapshot(1, {}, told::match_at(3, Seat::First)));
    const auto balls = shown_.balls(told::kNow);
    ASSERT_EQ(balls.size(), 2U);
    EXPECT_EQ(balls[1].ball, model::BallId{5});
    EXPECT_EQ(balls[1].state.position_m.x, 0.5);
}

TEST_F(PresentationTest, ShowsNothingWithoutATable) {
    EXPECT_EQ(shown_.table(), nullptr);
    EXPECT_TRUE(shown_.balls(told::kNow).empty());
}

TEST_F(PresentationTest, KeepsTheRulingUntilTheBallsRest) {
    tell(told::snapshot(1, {}, told::match_at(3, Seat::First)));
    tell(rolling_shot(2, 4));
    shown_.advance(told::kNow + seconds(1));
    ASSERT_NE(shown_.rolling(), nullptr);
    EXPECT_DOUBLE_EQ(cue_ball_x(told::kNow + seconds(1)), 0.5);
    EXPECT_EQ(shown_.table()->match->to_act, Seat::First);
    EXPECT_TRUE(shown_.lines().empty());

    shown_.advance(told::kNow + seconds(2));
    EXPECT_EQ(shown_.rolling(), nullptr);
    EXPECT_EQ(shown_.table()->match->to_act, Seat::Second);
    EXPECT_EQ(shown_.lines().size(), 1U);
}

TEST_F(PresentationTest, ShowsWhatFollowedTheShotAfterIt) {
    tell(told::snapshot(1, {}, told::match_at(3, Seat::First)));
    tell(rolling_shot(2, 4));
    tell(told::moved(3, Seat::Second, told::match_at(5, Seat::First, 1)));
    tell(told::over(4, Seat::First));
    EXPECT_FALSE(shown_.table()->over);
    shown_.advance(told::kNow + seconds(2));
    EXPECT_TRUE(shown_.table()->over);
    EXPECT_EQ(shown_.lines().size(), 3U);
}

TEST_F(PresentationTest, GivesUpARollWhenTheNextShotIsPlayed) {
    tell(told::snapshot(1, {}, told::match_at(3, Seat::First)));
    tell(rolling_shot(2, 4));
    tell(rolling_shot(3, 5));
    EXPECT_EQ(shown_.rolling()->shot().sequence, 3U);
    EXPECT_EQ(shown_.lines().size(), 1U);
}

TEST_F(PresentationTest, LeavesARackThatIsWonToBeSeenBeforeTheNext) {
    tell(told::snapshot(1, {}, told::match_at(3, Seat::First)));
    auto winning = rolling_shot(2, 4);
    winning.after.rack_number = 2;
    tell(winning);
    shown_.advance(told::kNow + seconds(2));
    shown_.advance(told::kNow + seconds(2) + kRackRests / 2);
    EXPECT_TRUE(shown_.rests());
    EXPECT_EQ(shown_.lines().size(), 1U);
    EXPECT_EQ(shown_.table()->match->rack_number, 1);
    EXPECT_DOUBLE_EQ(cue_ball_x(told::kNow + seconds(2)), 1.0);

    shown_.advance(told::kNow + seconds(2) + kRackRests);
    EXPECT_FALSE(shown_.rests());
    EXPECT_EQ(shown_.rolling(), nullptr);
    EXPECT_EQ(shown_.lines().size(), 1U);
    EXPECT_EQ(shown_.table()->match->rack_number, 2);
}

TEST_F(PresentationTest, EndsARollAtOnceWhenItIsSkipped) {
    tell(told::snapshot(1, {}, told::match_at(3, Seat::First)));
    tell(rolling_shot(2, 4));
    shown_.skip();
    EXPECT_EQ(shown_.rolling(), nullptr);
    EXPECT_EQ(shown_.table()->match->to_act, Seat::Second);
}

TEST_F(PresentationTest, SaysOnceThatAShotWasSeenToItsEnd) {
    tell(told::snapshot(1, {}, told::match_at(3, Seat::First)));
    tell(rolling_shot(2, 4));
    EXPECT_FALSE(shown_.take_seen());
    shown_.advance(told::kNow + seconds(2));
    EXPECT_EQ(shown_.take_seen(), 2U);
    EXPECT_FALSE(shown_.take_seen());
}

TEST_F(PresentationTest, ShowsALatecomerTheShotThatRolls) {
    auto snapshot = told::snapshot(9, {}, told::match_at(4, Seat::Second, 1));
    snapshot.rolling = rolling_shot(9, 4);
    tell(snapshot);
    ASSERT_NE(shown_.rolling(), nullptr);
    EXPECT_DOUBLE_EQ(cue_ball_x(told::kNow + milliseconds(500)), 0.25);
}

}  // namespace
}  // namespace billiards::client
