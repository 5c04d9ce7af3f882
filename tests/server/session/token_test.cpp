// Holds token hashing against a published digest.
#include "server/session/token.h"

#include <cstdint>
#include <gtest/gtest.h>

namespace billiards::server {
namespace {

TEST(Token, IsFilledWithRandomBytesToItsEnd) {
    std::uint8_t next = 1;
    const auto token = new_token([&](std::span<std::uint8_t> bytes) {
        for (std::uint8_t& byte : bytes) byte = next++;
    });
    EXPECT_EQ(token.front(), 1);
    EXPECT_EQ(token.back(), 32);
}

TEST(Token, IsHashedBySha256) {
    // SHA-256 of 32 zero bytes.
    const TokenHash expected{0x66, 0x68, 0x7a, 0xad, 0xf8, 0x62, 0xbd, 0x77, 0x6c, 0x8f, 0xc1,
                             0x8b, 0x8e, 0x9f, 0x8e, 0x20, 0x08, 0x97, 0x14, 0x85, 0x6e, 0xe2,
                             0x33, 0xb3, 0x90, 0x2a, 0x59, 0x1d, 0x0d, 0x5f, 0x29, 0x25};
    EXPECT_EQ(hash_of(protocol::ResumeToken{}), expected);
}

TEST(Token, ComparesEveryByteOfAHash) {
    const TokenHash hash = hash_of(protocol::ResumeToken{});
    EXPECT_TRUE(is_equal(hash, hash));
    for (std::size_t index = 0; index < hash.size(); ++index) {
        TokenHash other = hash;
        other[index] ^= 1U;
        EXPECT_FALSE(is_equal(hash, other)) << index;
    }
}

}  // namespace
}  // namespace billiards::server
