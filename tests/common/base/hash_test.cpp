// Pins the numbers that records, racks and goldens rest on.
#include "common/base/hash.h"

#include "common/base/random.h"

#include <gtest/gtest.h>
#include <set>

namespace billiards::base {
namespace {

TEST(Hasher, GivesTheSameDigestOnEveryMachine) {
    Hasher hasher;
    hasher.add(std::uint64_t{1});
    hasher.add(0.5);
    EXPECT_EQ(hasher.digest(), 0xd7aa6c4a55d6b8ceU);
}

TEST(Hasher, TellsOneChangedBitApart) {
    std::set<std::uint64_t> digests;
    for (unsigned bit = 0; bit < 64; ++bit) {
        Hasher hasher;
        hasher.add(std::uint64_t{1} << bit);
        hasher.add(std::uint64_t{0});
        digests.insert(hasher.digest());
    }
    EXPECT_EQ(digests.size(), 64U);
}

TEST(Random, GivesThePublishedNumbersOfSplitMix64) {
    Random random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317U);
    EXPECT_EQ(random.next(), 3203168211198807973U);
}

TEST(Random, StaysWithinItsBounds) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_LT(random.below(7), 7U);
        const double x = random.uniform(-1, 2);
        EXPECT_GE(x, -1);
        EXPECT_LT(x, 2);
    }
}

}  // namespace
}  // namespace billiards::base
