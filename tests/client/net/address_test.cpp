// Holds the reading of addresses against how people write them.
#include "client/net/address.h"

#include <gtest/gtest.h>

namespace billiards::client {
namespace {

TEST(Address, IsReadAsPeopleWriteIt) {
    const auto read = [](const char* text) { return parse_address(text); };
    const auto is = [](const char* host, std::uint16_t port) {
        return std::optional(ServerAddress{.host = host, .port = port});
    };
    EXPECT_EQ(read("example.org"), is("example.org", protocol::kDefaultPort));
    EXPECT_EQ(read("example.org:4000"), is("example.org", 4000));
    EXPECT_EQ(read("127.0.0.1:1"), is("127.0.0.1", 1));
    EXPECT_EQ(read("[::1]:65535"), is("::1", 65535));
    EXPECT_EQ(read("[::1]"), is("::1", protocol::kDefaultPort));
    EXPECT_EQ(read("fe80::1"), is("fe80::1", protocol::kDefaultPort));
}

TEST(Address, WhatIsNoneIsRefused) {
    for (const char* text : {"", ":4000", "host:", "host:0", "host:65536", "host:-1", "host:12x",
                             "[::1", "[]:4000", "[::1]x", "[::1]:"}) {
        EXPECT_FALSE(parse_address(text)) << text;
    }
}

TEST(Address, IsWrittenAsItIsRead) {
    for (const char* text : {"example.org:4000", "[::1]:4000", "1.2.3.4:1"}) {
        EXPECT_EQ(to_text(*parse_address(text)), text);
    }
}

}  // namespace
}  // namespace billiards::client
