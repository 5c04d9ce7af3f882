// Watches a match from its start at times of the test's choosing; gives whether each step is shown
// once the one before it rests, and whether every way through it leads where it says.
#include "client/play/rewatch.h"

#include "common/protocol/codec.h"
#include "common/protocol/framing.h"
#include "tests/client/app/told.h"

#include <gtest/gtest.h>
#include <vector>

namespace billiards::client {
namespace {

namespace server = protocol::server;
using model::Seat;
using std::chrono::milliseconds;

constexpr double kRoll_s = 2.0;

server::ShotPlayed rolling(std::uint64_t step, std::uint32_t turn, int shots) {
    server::ShotPlayed shot = told::shot(step, told::match_at(turn, Seat::First, shots), step);
    shot.struck_us = 1'000'000'000;  // Long ago, by another clock.
    shot.record.duration_s = kRoll_s;
    return shot;
}

/// Started, shot, extended, shot.
server::ReplayChunk chunk() {
    const std::vector<protocol::ServerMessage> story{
        server::MatchStarted{.sequence = 0, .state = told::match_at(1, Seat::First), .turn = {}},
        rolling(1, 2, 1), told::moved(2, Seat::First, told::match_at(2, Seat::First, 1)),
        rolling(3, 3, 2)};
    server::ReplayChunk chunk{.match = 3, .first = 0, .total = story.size(), .messages = {}};
    for (const protocol::ServerMessage& message : story) {
        const protocol::SharedFrame frame = protocol::encode(message);
        chunk.messages.emplace_back(frame->begin() + protocol::kFrameHeaderBytes, frame->end());
    }
    return chunk;
}

class RewatchTest : public testing::Test {
  protected:
    RewatchTest() { EXPECT_TRUE(rewatch_.take(chunk())); }

    static ClientState live() {
        ClientState live;
        live.table.emplace();
        live.table->match = told::match_at(9, Seat::Second, 8);
        return live;
    }
    void at(base::Duration after) { rewatch_.advance(began_ + after); }
    int shots() const { return rewatch_.presentation().table()->match->shots_played; }
    bool is_rolling() const { return rewatch_.presentation().rolling() != nullptr; }

    const base::Instant began_ = told::kNow;
    Rewatch rewatch_{live(), 0};
};

TEST_F(RewatchTest, BeginsWithTheMatchAsItBegan) {
    EXPECT_FALSE(rewatch_.question());
    EXPECT_EQ(rewatch_.steps(), 4U);
    EXPECT_EQ(rewatch_.step(), 0U);
    EXPECT_EQ(shots(), 0);
}

TEST_F(RewatchTest, PlaysEachStepOnceTheOneBeforeRests) {
    at(milliseconds(0));
    at(kBetweenSteps - milliseconds(1));
    EXPECT_FALSE(is_rolling());
    at(kBetweenSteps);
    EXPECT_TRUE(is_rolling());
    EXPECT_EQ(shots(), 0) << "the ruling waits until the balls rest";
    const base::Duration rests = kBetweenSteps + base::duration_of(kRoll_s);
    at(rests - milliseconds(1));
    EXPECT_TRUE(is_rolling()) << "it rolls as long as it did then";
    at(rests);
    EXPECT_FALSE(is_rolling());
    EXPECT_EQ(shots(), 1);
    at(rests + kBetweenSteps);
    EXPECT_EQ(rewatch_.step(), 2U);
    at(rests + 2 * kBetweenSteps);
    at(rests + 3 * kBetweenSteps);
    EXPECT_EQ(rewatch_.step(), 3U);
    EXPECT_TRUE(rewatch_.has_ended());
}

TEST_F(RewatchTest, NothingHappensWhileItIsPaused) {
    rewatch_.pause();
    at(milliseconds(0));
    at(10 * kBetweenSteps);
    EXPECT_EQ(rewatch_.step(), 0U);
    rewatch_.go_on();
    at(11 * kBetweenSteps);
    EXPECT_EQ(rewatch_.step(), 0U) << "the wait begins anew";
    at(12 * kBetweenSteps);
    EXPECT_EQ(rewatch_.step(), 1U);
}

TEST_F(RewatchTest, GoesFromShotToShotAndBack) {
    rewatch_.next_shot(began_);
    EXPECT_EQ(rewatch_.step(), 1U);
    EXPECT_TRUE(is_rolling());
    rewatch_.next_shot(began_);
    EXPECT_EQ(rewatch_.step(), 3U);
    EXPECT_EQ(shots(), 1) << "what was between is done";
    rewatch_.next_shot(began_);
    EXPECT_EQ(shots(), 2) << "behind the last shot there is its end";
    rewatch_.previous_shot(began_);
    EXPECT_EQ(rewatch_.step(), 1U);
    EXPECT_TRUE(is_rolling());
    rewatch_.previous_shot(began_);
    EXPECT_EQ(rewatch_.step(), 0U);
    EXPECT_FALSE(is_rolling());
}

TEST_F(RewatchTest, AnswersThatAreNoneEndIt) {
    EXPECT_FALSE(rewatch_.take(chunk())) << "nothing was asked";
    Rewatch fresh(live(), 0);
    server::ReplayChunk later = chunk();
    later.first = 2;
    EXPECT_FALSE(fresh.take(later));
    EXPECT_EQ(fresh.steps(), 0U);
}

}  // namespace
}  // namespace billiards::client
