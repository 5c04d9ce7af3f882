// Tells matches shot by shot; gives whether every rack's break, middle and end is drawn, and once.
#include "client/play/rack_pictures.h"

#include "client/app/reduce.h"
#include "tests/client/app/told.h"

#include <gtest/gtest.h>

namespace billiards::client {
namespace {

using model::Seat;
using Pictures = std::vector<DuePicture>;

constexpr int kRacked = 15;

class RackPicturesTest : public testing::Test {
  protected:
    RackPicturesTest() { tell(told::snapshot(1, {}, racked(1))); }

    Pictures tell(const protocol::ServerMessage& message) {
        const std::optional<TableView> before = state_.table;
        state_ = reduce(std::move(state_), message, told::kNow);
        return before ? pictures_.due(*before, *state_.table) : Pictures{};
    }

    static match::MatchState racked(int rack_number) {
        match::MatchState state;
        state.rack_number = rack_number;
        state.rack.phase = rules::Phase::Break;
        return state;
    }

    /// A shot of four seconds in the rack that is played, with so many object balls left.
    protocol::server::ShotPlayed shot(int left) {
        auto shot = told::shot(++sequence_, *state_.table->match);
        shot.after.rack.phase = rules::Phase::Groups;
        shot.record.duration_s = 4.0;
        for (int ball = 0; ball <= kRacked; ++ball) {
            shot.record.final_layout.balls.push_back(
                {.ball = model::BallId{static_cast<std::uint8_t>(ball)},
                 .place = ball <= left ? model::Place::OnTable : model::Place::Pocketed});
        }
        return shot;
    }

    protocol::server::ShotPlayed winning_shot(int left) {
        auto winning = shot(left);
        winning.verdict.winner = Seat::First;
        winning.after = racked(state_.table->match->rack_number + 1);
        return winning;
    }

    std::uint64_t sequence_ = 1;
    ClientState state_;
    RackPictures pictures_;
};

TEST_F(RackPicturesTest, ABreakIsDrawnWhileItRolls) {
    EXPECT_EQ(tell(shot(14)), (Pictures{{"rack1-break", 0.6}}));
    EXPECT_EQ(tell(shot(13)), Pictures{});
}

TEST_F(RackPicturesTest, AShortBreakIsDrawnHalfWay) {
    auto dry = shot(15);
    dry.record.duration_s = 0.5;
    EXPECT_EQ(tell(dry), (Pictures{{"rack1-break", 0.25}}));
}

TEST_F(RackPicturesTest, TheMiddleIsTheShotThatLeavesHalfOfTheBalls) {
    tell(shot(14));
    EXPECT_EQ(tell(shot(8)), Pictures{});
    EXPECT_EQ(tell(shot(7)), (Pictures{{"rack1-middle", 2.0}}));
    EXPECT_EQ(tell(shot(6)), Pictures{});
}

TEST_F(RackPicturesTest, TheEndIsDrawnAtRestAndTheNextRackBegins) {
    tell(shot(14));
    tell(shot(7));
    EXPECT_EQ(tell(winning_shot(3)), (Pictures{{"rack1-end", std::nullopt}}));
    EXPECT_EQ(tell(shot(14)), (Pictures{{"rack2-break", 0.6}}));
}

TEST_F(RackPicturesTest, ARackWonAtOnceHasAllThree) {
    EXPECT_EQ(tell(winning_shot(14)),
              (Pictures{{"rack1-break", 0.6}, {"rack1-middle", 2.0}, {"rack1-end", std::nullopt}}));
}

TEST_F(RackPicturesTest, ARackThatIsBrokenAgainHasOneBreak) {
    auto illegal = shot(15);
    illegal.after = racked(1);
    EXPECT_EQ(tell(illegal).size(), 1U);
    EXPECT_EQ(tell(shot(14)), Pictures{});
}

TEST_F(RackPicturesTest, TheLastEndWaitsUntilTheMatchIsOver) {
    tell(shot(14));
    auto winning = winning_shot(5);
    winning.after.stage = match::Stage::Over;
    winning.after.rack_number = 1;
    EXPECT_EQ(tell(winning), (Pictures{{"rack1-middle", 2.0}}));
    EXPECT_EQ(tell(told::over(++sequence_, Seat::First)), (Pictures{{"rack1-end", std::nullopt}}));
}

TEST_F(RackPicturesTest, AMatchThatIsGivenUpHasItsEnd) {
    tell(shot(14));
    EXPECT_EQ(tell(told::over(++sequence_, Seat::Second)), (Pictures{{"rack1-end", std::nullopt}}));
}

}  // namespace
}  // namespace billiards::client
