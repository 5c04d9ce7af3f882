// Takes a picture's path; gives a texture, or says what is wrong with the file.
#include "client/render/texture.h"

#include "client/scene/bitmap_limits.h"

#include <SDL.h>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <stdexcept>

namespace billiards::client {

namespace {

struct FreeSurface {
    void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};
using Surface = std::unique_ptr<SDL_Surface, FreeSurface>;

[[noreturn]] void refuse(const std::filesystem::path& bmp, std::string_view what) {
    throw std::runtime_error(
        fmt::format("The texture {} {}. make_assets makes it anew.", bmp.string(), what));
}

/// Rows from the top, three bytes a pixel without gaps between rows.
Surface read(const std::filesystem::path& bmp) {
    const Surface as_stored(SDL_LoadBMP(bmp.string().c_str()));
    if (!as_stored) refuse(bmp, fmt::format("cannot be read: {}", SDL_GetError()));
    if (const auto fault = bitmap_fault(as_stored->w, as_stored->h)) refuse(bmp, in_words(*fault));
    Surface surface(SDL_ConvertSurfaceFormat(as_stored.get(), SDL_PIXELFORMAT_RGBA32, 0));
    if (!surface) refuse(bmp, fmt::format("cannot be converted: {}", SDL_GetError()));
    return surface;
}

/// OpenGL's pictures begin at the bottom.
void turn_over(SDL_Surface& surface) {
    auto* pixels = static_cast<Uint8*>(surface.pixels);
    const int pitch = surface.pitch;
    for (int row = 0; row < surface.h / 2; ++row) {
        std::swap_ranges(pixels + row * pitch, pixels + (row + 1) * pitch,
                         pixels + (surface.h - 1 - row) * pitch);
    }
}

}  // namespace

GlTexture load_texture(const std::filesystem::path& bmp, bool is_fine) {
    const Surface surface = read(bmp);
    turn_over(*surface);
    GlTexture texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, surface->w, surface->h, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 surface->pixels);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    is_fine ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    if (is_fine && epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) {
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8.0F);
    }
    return texture;
}

}  // namespace billiards::client
