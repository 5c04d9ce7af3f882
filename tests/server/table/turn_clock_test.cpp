// Holds the clock of a turn: when it opens, runs, stands still and is given back.
#include "server/table/turn_clock.h"

#include <chrono>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;

base::Instant at(base::Duration time) {
    return base::Instant{time};
}

class TurnClockTest : public testing::Test {
  protected:
    TurnClockTest() { clock.set_running(at(0s), true); }
    TurnClock clock;
};

TEST_F(TurnClockTest, HasNoDeadlineWhileTheTurnWaits) {
    clock.wait_until(at(5s), 45s);
    EXPECT_TRUE(clock.is_waiting());
    EXPECT_EQ(clock.deadline(), std::nullopt);
    EXPECT_EQ(clock.view(), (protocol::server::Turn{.opens_us = 5'000'000, .deadline_us = {}}));
}

TEST_F(TurnClockTest, CountsFromTheOpeningThoughItCameEarly) {
    clock.wait_until(at(5s), 45s);
    clock.open(at(2s));
    EXPECT_TRUE(clock.is_open());
    EXPECT_EQ(clock.deadline(), at(47s));
    EXPECT_EQ(clock.view(),
              (protocol::server::Turn{.opens_us = 2'000'000, .deadline_us = 47'000'000}));
}

TEST_F(TurnClockTest, NeverEndsWithoutATimeAllowed) {
    clock.open(at(0s), std::nullopt);
    EXPECT_EQ(clock.deadline(), std::nullopt);
    EXPECT_FALSE(clock.set_running(at(1s), false));
    EXPECT_FALSE(clock.set_running(at(2s), true));
    EXPECT_EQ(clock.deadline(), std::nullopt);
}

TEST_F(TurnClockTest, StandsStillWhileNobodyIsThereAndGoesOnWithWhatWasLeft) {
    clock.open(at(0s), 45s);
    EXPECT_TRUE(clock.set_running(at(10s), false));
    EXPECT_EQ(clock.deadline(), std::nullopt);
    EXPECT_TRUE(clock.set_running(at(100s), true));
    EXPECT_EQ(clock.deadline(), at(135s));
}

TEST_F(TurnClockTest, IsFullForATurnThatOpenedWhileNobodyWasThere) {
    clock.wait_until(at(5s), 45s);
    EXPECT_FALSE(clock.set_running(at(1s), false));
    clock.open(at(5s));
    EXPECT_EQ(clock.deadline(), std::nullopt);
    EXPECT_TRUE(clock.set_running(at(60s), true));
    EXPECT_EQ(clock.deadline(), at(105s));
}

TEST_F(TurnClockTest, CanBeGivenBackInFull) {
    clock.open(at(0s), 45s);
    clock.open(at(44s), 45s);
    EXPECT_EQ(clock.deadline(), at(89s));
}

TEST_F(TurnClockTest, StopsWithTheMatch) {
    clock.open(at(0s), 45s);
    clock.stop();
    EXPECT_FALSE(clock.is_open());
    EXPECT_FALSE(clock.is_waiting());
    EXPECT_EQ(clock.deadline(), std::nullopt);
}

}  // namespace
}  // namespace billiards::server
