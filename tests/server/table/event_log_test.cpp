// Holds the log of a table's events: what it gives back, and what it forgets at each limit.
#include "server/table/event_log.h"

#include <gtest/gtest.h>
#include <memory>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <utility>

namespace billiards::server {
namespace {

protocol::SharedFrame frame_of(std::size_t bytes) {
    return std::make_shared<const std::vector<std::byte>>(bytes);
}

TEST(EventLog, GivesWhatCameAfterAnEventInItsOrder) {
    EventLog log({.events = 10, .bytes = 1000});
    std::vector<protocol::SharedFrame> frames;
    for (std::size_t i = 0; i < 5; ++i) {
        frames.push_back(frame_of(8));
        log.append(frames.back());
    }
    EXPECT_EQ(log.last(), 5U);
    EXPECT_EQ(log.since(0), frames);
    EXPECT_EQ(log.since(3), (std::vector{frames[3], frames[4]}));
    EXPECT_EQ(log.since(5), std::vector<protocol::SharedFrame>{});
}

TEST(EventLog, KnowsNothingOfNumbersThatWereNeverGiven) {
    EventLog log({.events = 10, .bytes = 1000});
    log.append(frame_of(8));
    EXPECT_EQ(log.since(2), std::nullopt);
    log.skip_to(7);
    EXPECT_EQ(log.since(6), std::nullopt);
    EXPECT_TRUE(log.since(7).has_value());
}

TEST(EventLog, ForgetsTheOldestOverItsNumberOfEvents) {
    EventLog log({.events = 3, .bytes = 1000});
    for (int i = 0; i < 4; ++i) log.append(frame_of(8));
    EXPECT_EQ(log.since(0), std::nullopt);
    EXPECT_EQ(log.since(1)->size(), 3U);
}

TEST(EventLog, ForgetsTheOldestOverItsBytes) {
    EventLog log({.events = 10, .bytes = 100});
    log.append(frame_of(60));
    log.append(frame_of(40));
    EXPECT_EQ(log.since(0)->size(), 2U);
    log.append(frame_of(8));
    EXPECT_EQ(log.since(0), std::nullopt);
    EXPECT_EQ(log.since(1)->size(), 2U);
    log.append(frame_of(200));
    EXPECT_EQ(log.bytes(), 0U);
    EXPECT_EQ(log.since(3), std::nullopt);
    EXPECT_TRUE(log.since(4)->empty());
}

RC_GTEST_PROP(EventLog, KeepsWithinItsLimitsTheNewestWithoutAGap,
              (const std::vector<std::uint8_t>& sizes)) {
    EventLog log({.events = 16, .bytes = 1024});
    std::vector<protocol::SharedFrame> all;
    for (const std::uint8_t size : sizes) {
        all.push_back(frame_of(size));
        log.append(all.back());
        RC_ASSERT(log.size() <= 16U);
        RC_ASSERT(log.bytes() <= 1024U);
    }
    for (std::size_t seen = 0; seen <= all.size(); ++seen) {
        const auto missed = log.since(seen);
        if (!missed) continue;
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(seen);
        RC_ASSERT(*missed == std::vector(first, all.end()));
    }
}

}  // namespace
}  // namespace billiards::server
