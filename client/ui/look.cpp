// Takes ImGui's defaults; gives ours.
#include "client/ui/look.h"

#include <filesystem>
#include <string>

namespace billiards::client {

namespace {

constexpr const char* kFontFolder = "/usr/share/fonts/truetype/lato/";

ImFont* font(const char* file, float size) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    const std::string path = std::string(kFontFolder) + file;
    std::error_code error;
    if (std::filesystem::exists(path, error)) {
        return fonts.AddFontFromFileTTF(path.c_str(), size);
    }
    ImFontConfig config;
    config.SizePixels = size;
    return fonts.AddFontDefault(&config);
}

void set_colors(ImGuiStyle& style) {
    const ImVec4 button{0.20F, 0.22F, 0.24F, 1.0F};
    const ImVec4 hovered{0.30F, 0.32F, 0.33F, 1.0F};
    const ImVec4 pressed{0.55F, 0.43F, 0.20F, 1.0F};
    style.Colors[ImGuiCol_Text] = colors::kText;
    style.Colors[ImGuiCol_TextDisabled] = colors::kQuiet;
    style.Colors[ImGuiCol_WindowBg] = colors::kPanel;
    style.Colors[ImGuiCol_PopupBg] = colors::kPanel;
    style.Colors[ImGuiCol_Border] = ImVec4{1.0F, 1.0F, 1.0F, 0.14F};
    style.Colors[ImGuiCol_Button] = button;
    style.Colors[ImGuiCol_ButtonHovered] = hovered;
    style.Colors[ImGuiCol_ButtonActive] = pressed;
    style.Colors[ImGuiCol_FrameBg] = ImVec4{0.14F, 0.15F, 0.165F, 1.0F};
    style.Colors[ImGuiCol_FrameBgHovered] = button;
    style.Colors[ImGuiCol_FrameBgActive] = hovered;
    style.Colors[ImGuiCol_CheckMark] = colors::kAccent;
    style.Colors[ImGuiCol_SliderGrab] = colors::kAccent;
    style.Colors[ImGuiCol_SliderGrabActive] = colors::kAccent;
    style.Colors[ImGuiCol_Header] = pressed;
    style.Colors[ImGuiCol_HeaderHovered] = hovered;
    style.Colors[ImGuiCol_HeaderActive] = pressed;
    style.Colors[ImGuiCol_NavHighlight] = colors::kAccent;
    style.Colors[ImGuiCol_Separator] = ImVec4{1.0F, 1.0F, 1.0F, 0.10F};
}

}  // namespace

Letters set_look(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsDark(&style);
    set_colors(style);
    style.WindowRounding = 0.0F;
    style.FrameRounding = 5.0F;
    style.GrabRounding = 5.0F;
    style.PopupRounding = 8.0F;
    style.ChildRounding = 5.0F;
    style.WindowBorderSize = 0.0F;
    style.FrameBorderSize = 1.0F;  // What is neither ticked nor chosen would hardly be seen.
    style.FramePadding = {10.0F, 5.0F};
    style.DisabledAlpha = 0.35F;
    style.ItemSpacing = {8.0F, 6.0F};
    style.WindowPadding = {14.0F, 12.0F};
    style.ScaleAllSizes(scale);
    ImGui::GetIO().Fonts->Clear();
    Letters letters;
    letters.normal = font("Lato-Regular.ttf", std::round(17.0F * scale));
    letters.small = font("Lato-Regular.ttf", std::round(14.5F * scale));
    letters.large = font("Lato-Semibold.ttf", std::round(21.0F * scale));
    letters.title = font("Lato-Black.ttf", std::round(44.0F * scale));
    return letters;
}

}  // namespace billiards::client
