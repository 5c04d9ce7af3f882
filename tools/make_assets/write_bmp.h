// Takes a picture; gives it as an uncompressed 24-bit .bmp file.
#pragma once

#include "tools/make_assets/byte_writer.h"
#include "tools/make_assets/picture.h"

namespace billiards::make_assets {

/// The width must be a multiple of four, so that rows need no padding.
Bytes write_bmp(const Picture& picture);

}  // namespace billiards::make_assets
