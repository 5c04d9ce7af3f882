// Takes a .bmp file; gives it to OpenGL as a texture.
#pragma once

#include "client/render/gl_objects.h"

#include <filesystem>

namespace billiards::client {

/// With mipmaps, repeating; fine ones stay sharp where they are seen from the side. Throws
/// std::runtime_error with a sentence where the file cannot be read, or is not within
/// bitmap_limits.h.
GlTexture load_texture(const std::filesystem::path& bmp, bool is_fine);

}  // namespace billiards::client
