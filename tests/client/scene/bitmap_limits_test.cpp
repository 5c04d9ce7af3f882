// Holds the sizes of textures against the limits of the original.
#include "client/scene/bitmap_limits.h"

#include <gtest/gtest.h>

namespace billiards::client {
namespace {

TEST(BitmapLimits, PowersOfTwoUpTo2048AreTextures) {
    EXPECT_EQ(bitmap_fault(1, 1), std::nullopt);
    EXPECT_EQ(bitmap_fault(512, 256), std::nullopt);
    EXPECT_EQ(bitmap_fault(2048, 2048), std::nullopt);
}

TEST(BitmapLimits, AnythingElseIsNamed) {
    EXPECT_EQ(bitmap_fault(0, 256), BitmapFault::Empty);
    EXPECT_EQ(bitmap_fault(256, -256), BitmapFault::Empty);
    EXPECT_EQ(bitmap_fault(4096, 256), BitmapFault::TooLarge);
    EXPECT_EQ(bitmap_fault(256, 2049), BitmapFault::TooLarge);
    EXPECT_EQ(bitmap_fault(640, 512), BitmapFault::NotAPowerOfTwo);
    EXPECT_EQ(bitmap_fault(512, 480), BitmapFault::NotAPowerOfTwo);
}

}  // namespace
}  // namespace billiards::client
