// Takes the back buffer; writes a .png.
#include "client/render/picture.h"

#include <SDL_image.h>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <memory>
#include <stdexcept>
#include <vector>

namespace billiards::client {

void save_picture(const Window& window, const std::filesystem::path& png) {
    constexpr int kBytes = 3;
    const Window::Size size = window.drawable_size();
    const auto pitch = static_cast<std::size_t>(size.width) * kBytes;
    std::vector<unsigned char> upwards(pitch * static_cast<std::size_t>(size.height));
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, upwards.data());

    std::vector<unsigned char> downwards;
    downwards.reserve(upwards.size());
    for (auto row = upwards.end(); row != upwards.begin();) {
        row -= static_cast<std::ptrdiff_t>(pitch);
        downwards.insert(downwards.end(), row, row + static_cast<std::ptrdiff_t>(pitch));
    }
    const std::unique_ptr<SDL_Surface, decltype(&SDL_FreeSurface)> surface(
        SDL_CreateRGBSurfaceWithFormatFrom(downwards.data(), size.width, size.height, 8 * kBytes,
                                           static_cast<int>(pitch), SDL_PIXELFORMAT_RGB24),
        SDL_FreeSurface);
    if (!surface || IMG_SavePNG(surface.get(), png.string().c_str()) != 0) {
        throw std::runtime_error(
            fmt::format("The picture {} cannot be written: {}", png.string(), SDL_GetError()));
    }
}

}  // namespace billiards::client
