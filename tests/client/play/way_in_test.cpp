// Takes what people type and paste; gives whether it leads where they mean.
#include "client/play/way_in.h"

#include <gtest/gtest.h>

namespace billiards::client {
namespace {

TEST(WayIn, AnAddressLeadsToItsServer) {
    const auto way = way_in("example.org:1234", protocol::Role::Player);
    ASSERT_TRUE(way);
    EXPECT_EQ(way->address, (ServerAddress{.host = "example.org", .port = 1234}));
    EXPECT_FALSE(way->join);
}

TEST(WayIn, TheLinkOfAnInviteLeadsToItsTable) {
    const protocol::server::InviteMade made{
        .table = {7}, .is_for_playing = true, .secret = {1, 2, 255}, .expires_us = 0};
    const ServerAddress server{.host = "192.168.1.5", .port = 4747};
    const auto way = way_in(link_of(made, server), protocol::Role::Spectator);
    ASSERT_TRUE(way && way->join);
    EXPECT_EQ(way->address, server);
    EXPECT_EQ(*way->join, (protocol::client::Join{.table = {7},
                                                  .role = protocol::Role::Spectator,
                                                  .invite = made.secret,
                                                  .passcode = {}}));
}

TEST(WayIn, WhatIsNeitherLeadsNowhere) {
    EXPECT_FALSE(way_in("", protocol::Role::Player));
    EXPECT_FALSE(way_in("[", protocol::Role::Player));
}

}  // namespace
}  // namespace billiards::client
