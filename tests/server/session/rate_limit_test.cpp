// Holds the rate limit against its two promises: a burst, then one an interval.
#include "server/session/rate_limit.h"

#include <chrono>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;

int passed(RateLimit& limit, base::Instant from, base::Duration every, int attempts) {
    int count = 0;
    for (int i = 0; i < attempts; ++i) count += limit.allows(from + i * every) ? 1 : 0;
    return count;
}

TEST(RateLimit, LetsAWholePeriodsCountPassAtOnceAndNotOneMore) {
    RateLimit limit(8, 10s);
    EXPECT_EQ(passed(limit, base::Instant{}, 0us, 100), 8);
}

TEST(RateLimit, LetsOnePassAnIntervalOnceTheBurstIsSpent) {
    RateLimit limit(8, 10s);
    passed(limit, base::Instant{}, 0us, 8);
    EXPECT_FALSE(limit.allows(base::Instant{1249ms}));
    EXPECT_TRUE(limit.allows(base::Instant{1250ms}));
    EXPECT_FALSE(limit.allows(base::Instant{1250ms}));
}

TEST(RateLimit, TellsWhetherThereIsRoomWithoutTakingIt) {
    RateLimit limit(1, 10s);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(limit.has_room(base::Instant{}));
    EXPECT_TRUE(limit.allows(base::Instant{}));
    EXPECT_FALSE(limit.has_room(base::Instant{9999ms}));
    EXPECT_TRUE(limit.has_room(base::Instant{10s}));
}

TEST(RateLimit, DoesNotSaveUpMoreThanTheBurst) {
    RateLimit limit(8, 10s);
    limit.allows(base::Instant{});
    EXPECT_EQ(passed(limit, base::Instant{1h}, 0us, 100), 8);
}

TEST(RateLimit, KeepsTheRateOverALongTimeWhateverIsAsked) {
    RateLimit limit(4, 1s, 2);
    EXPECT_NEAR(passed(limit, base::Instant{}, 1ms, 60'000), 4 * 60, 2);
}

TEST(RateLimit, LetsWhoKeepsTheRatePassThoughTheirTimingShakes) {
    RateLimit limit(10, 1s, 2);
    for (int i = 0; i < 100; ++i) {
        const base::Duration shake = i % 2 == 0 ? 0ms : 40ms;
        EXPECT_TRUE(limit.allows(base::Instant{i * 100ms + shake})) << i;
    }
}

TEST(RateLimit, RefusedOnesCostNothing) {
    RateLimit limit(1, 1s);
    EXPECT_TRUE(limit.allows(base::Instant{}));
    EXPECT_EQ(passed(limit, base::Instant{1ms}, 1ms, 900), 0);
    EXPECT_TRUE(limit.allows(base::Instant{1s}));
}

}  // namespace
}  // namespace billiards::server
