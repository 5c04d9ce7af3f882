// Takes the name of a scene; brings a screen there by itself, for a picture.
#pragma once

#include "client/ui/screen.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

/// Once a frame; true when the screen shows the scene.
using SceneStep = std::function<bool(Screen&)>;

/// None where there is no scene of this name.
std::optional<SceneStep> scene_named(const std::string& name);
std::vector<std::string> scene_names();

}  // namespace billiards::client
