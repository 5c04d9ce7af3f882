// Takes what was drawn; gives it as a file.
#pragma once

#include "client/render/window.h"

#include <filesystem>

namespace billiards::client {

/// Saves the back buffer as a .png, before it is presented. Throws std::runtime_error with a
/// sentence where the file cannot be written.
void save_picture(const Window& window, const std::filesystem::path& png);

}  // namespace billiards::client
