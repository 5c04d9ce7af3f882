// Gives the colours, sizes and letters of everything that is not the table.
#pragma once

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace billiards::client {

/// Lengths of the interface are for a window of this height, in its units.
inline constexpr float kDesignedHeight = 720.0F;
inline constexpr float kPanelWidth = 300.0F;

/// What those lengths are multiplied by: 1.25 in a window 1080 high. In steps, so that a window
/// that is dragged larger does not need new letters all the time.
inline float interface_scale(float window_height) {
    const float above = window_height - kDesignedHeight;
    const float scale = 1.0F + (above > 0 ? 0.5F : 1.0F) * above / kDesignedHeight;
    return std::clamp(std::round(20.0F * scale) / 20.0F, 0.8F, 3.0F);
}

namespace colors {
inline const ImVec4 kText{0.93F, 0.91F, 0.87F, 1.0F};
inline const ImVec4 kQuiet{0.66F, 0.64F, 0.60F, 1.0F};
inline const ImVec4 kAccent{0.85F, 0.66F, 0.30F, 1.0F};
inline const ImVec4 kWarning{0.95F, 0.45F, 0.36F, 1.0F};
inline const ImVec4 kPanel{0.085F, 0.095F, 0.105F, 0.97F};
}  // namespace colors

struct Letters {
    ImFont* normal = nullptr;
    ImFont* small = nullptr;
    ImFont* large = nullptr;
    ImFont* title = nullptr;
};

/// Not within a frame; earlier letters are gone. Lato where it is installed, else ImGui's own.
Letters set_look(float scale);

}  // namespace billiards::client
