// Holds the hashing of secrets against published digests.
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

// The digests below are sha256sum's (GNU coreutils).

TEST(Invite, IsHashedBySha256) {
    const SecretHash expected{0x37, 0x47, 0x08, 0xff, 0xf7, 0x71, 0x9d, 0xd5, 0x97, 0x9e, 0xc8,
                              0x75, 0xd5, 0x6c, 0xd2, 0x28, 0x6f, 0x6d, 0x3c, 0xf7, 0xec, 0x31,
                              0x7a, 0x3b, 0x25, 0x63, 0x2a, 0xab, 0x28, 0xec, 0x37, 0xbb};
    EXPECT_EQ(hash_of(protocol::InviteSecret{}), expected);
}

TEST(Passcode, IsHashedBySha256AfterItsSalt) {
    const SecretHash expected{0xeb, 0x8b, 0xaa, 0xd0, 0x72, 0xbb, 0x9b, 0x69, 0x93, 0xe4, 0x31,
                              0x5c, 0x22, 0xfb, 0xad, 0x45, 0xae, 0x15, 0xc3, 0x4e, 0xde, 0xc9,
                              0xe8, 0xdc, 0xfa, 0x1b, 0x77, 0x90, 0x92, 0x4d, 0xd6, 0x25};
    Salt salt{};
    EXPECT_EQ(hash_of(salt, "cue"), expected);
    salt.front() = 1;
    EXPECT_NE(hash_of(salt, "cue"), expected);
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
