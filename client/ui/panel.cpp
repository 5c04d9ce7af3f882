// Takes clicks and drags on the panel; changes the eye, and draws the frame of it all. The groups
// stand in the original's order, under its names.
#include "client/ui/panel.h"

#include "client/play/information.h"
#include "client/ui/panel_parts.h"

#include <algorithm>
#include <numbers>

namespace billiards::client {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kOrbitPerUnit_rad = 0.35 * kDegree;
constexpr float kLeastInformationHeight = 96.0F;
/// Of everything below the information box.
constexpr float kControlsHeight = 546.0F;
constexpr float kCrossHeight = 42.0F;

void group(const Screen& screen, const char* name) {
    ImGui::PushFont(screen.letters.small);
    ImGui::TextColored(colors::kAccent, "%s", name);
    ImGui::PopFont();
    ImGui::Separator();
}

void draw_information(Screen& screen) {
    const float height =
        std::max(kLeastInformationHeight * screen.scale,
                 ImGui::GetContentRegionAvail().y - kControlsHeight * screen.scale);
    ImGui::BeginChild("information", {0.0F, height}, true);
    ImGui::PushFont(screen.letters.small);
    const std::vector<std::string> lines = information(screen.game);
    for (const std::string& line : lines) {
        const bool is_newest = &line == &lines.back();
        ImGui::PushStyleColor(ImGuiCol_Text, is_newest ? colors::kText : colors::kQuiet);
        ImGui::TextWrapped("%s", line.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopFont();
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1.0F);
    ImGui::EndChild();
    screen.controls.note("Information");
}

/// Four arrows out of one place, on the last item, and its name beside them.
void draw_cross(const Screen& screen) {
    const ImVec2 middle = middle_of_last_item();
    const ImVec2 size = ImGui::CalcTextSize("Rotate");
    const float reach = 17.0F * screen.scale;
    const float gap = 10.0F * screen.scale;
    const ImVec2 cross{middle.x - (size.x + gap) / 2, middle.y};
    for (const auto& [x, y] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
        draw_arrow(
            screen, cross,
            {cross.x + reach * static_cast<float>(x), cross.y + reach * static_cast<float>(y)});
    }
    ImGui::GetWindowDrawList()->AddText({cross.x + reach + gap, middle.y - size.y / 2}, ink(),
                                        "Rotate");
}

void draw_camera(Screen& screen) {
    ImGui::Button("##rotate", {full_width(), kCrossHeight * screen.scale});
    screen.controls.note("Rotate");
    draw_cross(screen);
    const ImVec2 drag = drag_on_last_item();
    screen.camera.orbit(-drag.x * kOrbitPerUnit_rad, drag.y * kOrbitPerUnit_rad);
    if (ImGui::RadioButton("Follow Ball", screen.follows_ball)) screen.follows_ball = true;
    screen.controls.note("Follow Ball");
    ImGui::SameLine();
    if (ImGui::RadioButton("Center of Table", !screen.follows_ball)) screen.follows_ball = false;
    screen.controls.note("Center of Table");
    if (ImGui::Button("Reset Camera", {full_width(), 0.0F})) screen.camera.reset();
    screen.controls.note("Reset Camera");
}

void draw_followed(Screen& screen) {
    const auto name_of = [](int number) {
        return number == 0 ? std::string("Cue Ball") : std::to_string(number);
    };
    ImGui::SetNextItemWidth(full_width());
    const bool is_open = ImGui::BeginCombo("##followed", name_of(screen.followed.number).c_str(),
                                           ImGuiComboFlags_HeightLargest);
    screen.controls.note("Follow a Ball");
    if (!is_open) return;
    for (std::uint8_t number = 0; number <= 15; ++number) {
        const std::string name = name_of(number);
        if (ImGui::Selectable(name.c_str(), screen.followed.number == number)) {
            screen.followed.number = number;
        }
        screen.controls.note("Follow " + name);
    }
    ImGui::EndCombo();
}

void draw_zoom(Screen& screen) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {padding.x / 4, padding.y});
    const float width = (full_width() - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    if (ImGui::Button("Zoom In", {width, 0.0F})) screen.camera.zoom(1);
    screen.controls.note("Zoom In");
    ImGui::SameLine();
    if (ImGui::Button("Zoom Out", {width, 0.0F})) screen.camera.zoom(-1);
    screen.controls.note("Zoom Out");
    ImGui::SameLine();
    if (ImGui::Button("Reset Zoom", {width, 0.0F})) screen.camera.reset_zoom();
    screen.controls.note("Reset Zoom");
    ImGui::PopStyleVar();
}

/// The handle that folds the panel away, and back.
void draw_fold(Screen& screen, const ImVec2& display) {
    const ImVec2 handle{22.0F * screen.scale, 64.0F * screen.scale};
    const float right = screen.table_width(display.x);
    ImGui::SetNextWindowPos({right - handle.x, display.y / 2 - handle.y / 2});
    ImGui::SetNextWindowSize(handle);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::Begin("fold", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoNav);
    if (ImGui::Button(screen.is_panel_folded ? "<" : ">", handle)) {
        screen.is_panel_folded = !screen.is_panel_folded;
    }
    screen.controls.note("Fold Panel");
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace

void draw_panel(Screen& screen) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    draw_fold(screen, display);
    if (screen.is_panel_folded) return;
    const float width = kPanelWidth * screen.scale;
    ImGui::SetNextWindowPos({display.x - width, 0.0F});
    ImGui::SetNextWindowSize({width, display.y});
    ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    draw_information(screen);
    group(screen, "Cue");
    draw_cue_group(screen);
    group(screen, "Camera");
    draw_camera(screen);
    group(screen, "Follow a Ball");
    draw_followed(screen);
    draw_zoom(screen);
    ImGui::End();
}

}  // namespace billiards::client
