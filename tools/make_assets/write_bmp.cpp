// Takes a picture; gives file head, information head and pixels.
#include "tools/make_assets/write_bmp.h"

#include "common/base/check.h"

#include <cmath>
#include <utility>

namespace billiards::make_assets {

namespace {

std::uint8_t channel(double value) {
    return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5));
}

}  // namespace

Bytes write_bmp(const Picture& picture) {
    CHECK(picture.width % 4 == 0);
    constexpr std::uint32_t kHeads = 14 + 40;
    const auto pixel_bytes = static_cast<std::uint32_t>(3 * picture.pixels.size());
    ByteWriter file;
    file.u8('B');
    file.u8('M');
    file.u32(kHeads + pixel_bytes);
    file.u32(0);
    file.u32(kHeads);  // Where the pixels begin.

    file.u32(40);
    file.u32(static_cast<std::uint32_t>(picture.width));
    file.u32(static_cast<std::uint32_t>(picture.height));
    file.u16(1);
    file.u16(24);
    file.u32(0);  // Not compressed.
    file.u32(pixel_bytes);
    for (int i = 0; i < 4; ++i) file.u32(0);  // No print size, no palette.

    for (const Colour& pixel : picture.pixels) {
        file.u8(channel(pixel.b));
        file.u8(channel(pixel.g));
        file.u8(channel(pixel.r));
    }
    return std::move(file).take();
}

}  // namespace billiards::make_assets
