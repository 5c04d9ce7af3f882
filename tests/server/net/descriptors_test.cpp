// Holds the share of descriptors that connections may take.
#include "server/net/descriptors.h"

#include <gtest/gtest.h>

namespace billiards::server {
namespace {

TEST(Descriptors, AreKeptForFilesWhereThereAreFewerThanConnectionsWanted) {
    EXPECT_EQ(connections_within(20'000, 1'048'576, 64), 20'000U);
    EXPECT_EQ(connections_within(20'000, 20'064, 64), 20'000U);
    EXPECT_EQ(connections_within(20'000, 20'063, 64), 19'999U);
    EXPECT_EQ(connections_within(20'000, 1024, 64), 960U);
}

TEST(Descriptors, AreSharedByHalvesWhereThereAreVeryFew) {
    EXPECT_EQ(connections_within(20'000, 128, 64), 64U);
    EXPECT_EQ(connections_within(20'000, 100, 64), 50U);
    EXPECT_EQ(connections_within(20'000, 1, 64), 1U);
    EXPECT_EQ(connections_within(5, 100, 64), 5U);
}

TEST(Descriptors, AreAllowedToThisProcess) {
    EXPECT_GT(descriptors_allowed(), 0U);
}

}  // namespace
}  // namespace billiards::server
