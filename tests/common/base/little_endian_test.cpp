// Pins the bytes of numbers, as frames, replays and models have them.
#include "common/base/little_endian.h"

#include <array>
#include <gtest/gtest.h>

namespace billiards::base {
namespace {

using Bytes = std::vector<std::byte>;

TEST(LittleEndian, BeginsWithTheLowestByte) {
    std::array<std::byte, 2> two{};
    put_number(two, 0x1234);
    EXPECT_EQ(two, (std::array{std::byte{0x34}, std::byte{0x12}}));
    EXPECT_EQ(number_in(two), 0x1234U);
}

TEST(LittleEndian, AppendsBehindWhatIsThere) {
    Bytes bytes{std::byte{7}};
    append_number(bytes, 1, 3);
    EXPECT_EQ(bytes, (Bytes{std::byte{7}, std::byte{1}, std::byte{0}, std::byte{0}}));
}

TEST(LittleEndian, KeepsAllThe64Bits) {
    Bytes bytes;
    append_number(bytes, 0xfedcba9876543210U, 8);
    EXPECT_EQ(number_in(bytes), 0xfedcba9876543210U);
}

}  // namespace
}  // namespace billiards::base
