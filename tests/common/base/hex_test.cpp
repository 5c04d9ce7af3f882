// Pins how hashes are shown.
#include "common/base/hex.h"

#include <gtest/gtest.h>

namespace billiards::base {
namespace {

TEST(Hex, HasSixteenDigitsWhateverTheNumber) {
    EXPECT_EQ(to_hex(0), "0000000000000000");
    EXPECT_EQ(to_hex(0x00ff00000000a1b2U), "00ff00000000a1b2");
    EXPECT_EQ(to_hex(0xfedcba9876543210U), "fedcba9876543210");
}

}  // namespace
}  // namespace billiards::base
