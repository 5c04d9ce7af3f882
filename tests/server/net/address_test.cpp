// Holds addresses, and the limits on them, against what people write and who connects.
#include "server/net/address.h"

#include "server/net/address_limits.h"

#include <gtest/gtest.h>
#include <string>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;
using Moment = AddressLimits::Clock::time_point;

TEST(Address, IsReadAndWrittenAlike) {
    for (const char* text :
         {"127.0.0.1:4747", "0.0.0.0:0", "[::1]:65535", "[::]:1", "[2001:db8::7]:4747"}) {
        const auto endpoint = parse_endpoint(text);
        ASSERT_TRUE(endpoint) << text;
        EXPECT_EQ(to_text(*endpoint), text);
    }
}

TEST(Address, IsNotReadWhereItIsNone) {
    for (const char* text : {"", ":", "4747", "127.0.0.1", "127.0.0.1:", "127.0.0.1:65536",
                             "127.0.0.1:-1", "127.0.0.1:47 ", "localhost:4747", "::1:4747", "[::1]",
                             "[127.0.0.1]:1", "[]:1", "[::1:4747", "256.0.0.1:1"}) {
        EXPECT_FALSE(parse_endpoint(text)) << text;
    }
}

TEST(Address, IsLoopbackWhereOnlyThisMachineReachesIt) {
    for (const char* text : {"127.0.0.1", "127.9.9.9", "::1", "::ffff:127.0.0.1"}) {
        EXPECT_TRUE(is_loopback(asio::ip::make_address(text))) << text;
    }
    for (const char* text : {"0.0.0.0", "::", "192.168.0.1", "::ffff:10.0.0.1", "fe80::1"}) {
        EXPECT_FALSE(is_loopback(asio::ip::make_address(text))) << text;
    }
}

AddressKey key(const char* address) {
    return AddressLimits::key_of(asio::ip::make_address(address));
}

/// A moment well after the clock's zero, as a real one is.
constexpr Moment kStart{1h};

int admitted_of(AddressLimits& limits, const char* address, int tries, Moment now) {
    int admitted = 0;
    for (int i = 0; i < tries; ++i) admitted += limits.admit(key(address), now) ? 1 : 0;
    return admitted;
}

TEST(AddressLimits, CountAHouseholdOfIPv6AsOneAddress) {
    EXPECT_EQ(key("2001:db8:0:7::1"), key("2001:db8:0:7:ffff::2"));
    EXPECT_NE(key("2001:db8:0:7::1"), key("2001:db8:0:8::1"));
    EXPECT_EQ(key("192.0.2.1"), key("::ffff:192.0.2.1"));
    EXPECT_NE(key("192.0.2.1"), key("192.0.2.2"));
}

TEST(AddressLimits, LetInOnlySoManyNewConnectionsAWindow) {
    AddressLimits limits({});
    EXPECT_EQ(admitted_of(limits, "192.0.2.1", 30, kStart), 20);
    EXPECT_EQ(admitted_of(limits, "192.0.2.2", 30, kStart), 20);
    EXPECT_EQ(admitted_of(limits, "192.0.2.1", 30, kStart + 9s), 0);
    EXPECT_EQ(admitted_of(limits, "192.0.2.1", 30, kStart + 10s), 20);
}

TEST(AddressLimits, LetInOnlySoManyAtOnce) {
    AddressLimits limits({});
    int admitted = 0;
    for (int window = 0; window < 6; ++window) {
        admitted += admitted_of(limits, "192.0.2.1", 20, kStart + window * 10s);
    }
    EXPECT_EQ(admitted, 64);
    limits.release(key("192.0.2.1"));
    EXPECT_EQ(admitted_of(limits, "192.0.2.1", 20, kStart + 60s), 1);
}

TEST(AddressLimits, LetInLoopbackAlways) {
    AddressLimits limits({});
    EXPECT_EQ(admitted_of(limits, "127.0.0.1", 1000, kStart), 1000);
    EXPECT_EQ(admitted_of(limits, "::1", 1000, kStart), 1000);
    limits.release(key("127.0.0.1"));
}

TEST(AddressLimits, RememberOnlySoManyAddressesAndForgetThoseThatAreGone) {
    AddressLimits limits({.addresses = 2});
    EXPECT_TRUE(limits.admit(key("192.0.2.1"), kStart));
    EXPECT_TRUE(limits.admit(key("192.0.2.2"), kStart));
    EXPECT_FALSE(limits.admit(key("192.0.2.3"), kStart));
    limits.release(key("192.0.2.1"));
    limits.forget_old(kStart + 9s);
    EXPECT_FALSE(limits.admit(key("192.0.2.3"), kStart + 9s));
    limits.forget_old(kStart + 10s);
    EXPECT_TRUE(limits.admit(key("192.0.2.3"), kStart + 10s));
    EXPECT_FALSE(limits.admit(key("192.0.2.4"), kStart + 10s));
}

}  // namespace
}  // namespace billiards::server
