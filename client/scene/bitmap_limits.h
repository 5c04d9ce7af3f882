// Takes the size of a .bmp picture; gives whether it can be a texture.
#pragma once

#include "common/base/check.h"

#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>

namespace billiards::client {

/// The original's limits for textures: a power of two each way, and at most this many pixels.
inline constexpr int kMaxTextureSize = 2048;

enum class BitmapFault : std::uint8_t { Empty, TooLarge, NotAPowerOfTwo };

constexpr std::optional<BitmapFault> bitmap_fault(int width, int height) {
    if (width <= 0 || height <= 0) return BitmapFault::Empty;
    if (width > kMaxTextureSize || height > kMaxTextureSize) return BitmapFault::TooLarge;
    const bool are_powers = std::has_single_bit(static_cast<unsigned>(width)) &&
                            std::has_single_bit(static_cast<unsigned>(height));
    return are_powers ? std::nullopt : std::optional(BitmapFault::NotAPowerOfTwo);
}

/// The part of a sentence that follows "the texture".
constexpr std::string_view in_words(BitmapFault fault) {
    switch (fault) {
        case BitmapFault::Empty:
            return "has no pixels";
        case BitmapFault::TooLarge:
            return "is larger than 2048 pixels";
        case BitmapFault::NotAPowerOfTwo:
            return "has a width or height that is no power of two";
    }
    CHECK(false);
}

}  // namespace billiards::client
