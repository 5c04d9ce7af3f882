// Gives the colours, sizes and letters of everything that is not the table.
#pragma once

#include <imgui.h>

namespace billiards::client {

inline constexpr float kPanelWidth = 300.0F;

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

/// Once a context. Lato where it is installed, else ImGui's own letters.
Letters set_look();

}  // namespace billiards::client
