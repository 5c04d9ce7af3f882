// Holds the deadlines against a list that is searched in full.
#include "server/session/deadlines.h"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>
#include <map>
#include <rapidcheck/gtest.h>
#include <utility>
#include <vector>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;

base::Instant at(std::int64_t time_us) {
    return base::Instant{base::Duration{time_us}};
}

TEST(Deadlines, WaitForNothingAtFirst) {
    Deadlines<int> deadlines;
    EXPECT_EQ(deadlines.next(), std::nullopt);
    EXPECT_TRUE(deadlines.take_due(at(1'000'000)).empty());
}

TEST(Deadlines, AreDueAtTheirMomentNotBefore) {
    Deadlines<int> deadlines;
    deadlines.set(7, at(100));
    EXPECT_TRUE(deadlines.take_due(at(99)).empty());
    EXPECT_EQ(deadlines.take_due(at(100)), std::vector{7});
    EXPECT_TRUE(deadlines.take_due(at(100)).empty());
}

TEST(Deadlines, AreReplacedNotAdded) {
    Deadlines<int> deadlines;
    deadlines.set(7, at(100));
    deadlines.set(7, at(300));
    EXPECT_EQ(deadlines.next(), at(300));
    EXPECT_TRUE(deadlines.take_due(at(299)).empty());
}

TEST(Deadlines, CanBeTakenAway) {
    Deadlines<int> deadlines;
    deadlines.set(7, at(100));
    deadlines.set(7, std::nullopt);
    EXPECT_EQ(deadlines.next(), std::nullopt);
}

RC_GTEST_PROP(Deadlines, AgreeWithASearchOfAll, (std::vector<std::pair<int, int>> settings)) {
    Deadlines<int> deadlines;
    std::map<int, int> model;
    for (const auto& [key, time_us] : settings) {
        if (time_us % 5 == 0) {
            deadlines.set(key % 8, std::nullopt);
            model.erase(key % 8);
        } else {
            deadlines.set(key % 8, at(time_us));
            model[key % 8] = time_us;
        }
    }
    std::vector<std::pair<int, int>> expected;
    for (const auto& [key, time_us] : model) {
        if (time_us <= 50) expected.emplace_back(time_us, key);
    }
    std::sort(expected.begin(), expected.end());
    std::vector<int> keys;
    for (const auto& [time_us, key] : expected) keys.push_back(key);
    RC_ASSERT(deadlines.take_due(at(50)) == keys);
}

}  // namespace
}  // namespace billiards::server
