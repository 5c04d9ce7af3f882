// Takes clicks and drags on the panel; changes the shot, the eye and the call. The groups stand in
// the original's order, under its names.
#include "client/ui/panel.h"

#include "client/app/narrate.h"
#include "client/play/information.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <numbers>

namespace billiards::client {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kCueTurnPerUnit_rad = 0.1 * kDegree;
constexpr double kOrbitPerUnit_rad = 0.35 * kDegree;
constexpr float kLeastInformationHeight = 96.0F;
/// Of everything below the information box.
constexpr float kControlsHeight = 546.0F;
constexpr float kSpinPicture = 92.0F;
constexpr float kCrossHeight = 42.0F;
constexpr float kWordsBeside = 74.0F;  ///< Where a row's control begins, right of its name.
const ImU32 kInk = ImGui::ColorConvertFloat4ToU32(colors::kText);

float full_width() {
    return ImGui::GetContentRegionAvail().x;
}

void group(const Screen& screen, const char* name) {
    ImGui::PushFont(screen.letters.small);
    ImGui::TextColored(colors::kAccent, "%s", name);
    ImGui::PopFont();
    ImGui::Separator();
}

/// A line with a head at its end, to be dragged that way.
void draw_arrow(const Screen& screen, const ImVec2& from, const ImVec2& to) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const ImVec2 along{(to.x - from.x) / length, (to.y - from.y) / length};
    const float head = 5.0F * screen.scale;
    const ImVec2 neck{to.x - head * along.x, to.y - head * along.y};
    const ImVec2 aside{-0.8F * head * along.y, 0.8F * head * along.x};
    draw.AddLine(from, neck, kInk, 1.6F * screen.scale);
    draw.AddTriangleFilled(to, {neck.x + aside.x, neck.y + aside.y},
                           {neck.x - aside.x, neck.y - aside.y}, kInk);
}

ImVec2 middle_of_last_item() {
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    return {(from.x + to.x) / 2, (from.y + to.y) / 2};
}

/// How far the mouse was dragged since the last frame, while the control is held. The way to it is
/// no drag, even where a slow frame saw both at once.
ImVec2 drag_on_last_item() {
    const bool is_dragged = ImGui::IsItemActive() && !ImGui::IsItemActivated();
    return is_dragged ? ImGui::GetIO().MouseDelta : ImVec2{0.0F, 0.0F};
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

void draw_rotate_cue(Screen& screen) {
    ImGui::Button("Rotate Cue", {full_width(), 0.0F});
    screen.controls.note("Rotate Cue");
    const ImVec2 middle = middle_of_last_item();
    for (const float side : {-1.0F, 1.0F}) {
        const float from = middle.x + side * 52.0F * screen.scale;
        const float to = middle.x + side * 108.0F * screen.scale;
        draw_arrow(screen, {from, middle.y}, {to, middle.y});
    }
    const ImVec2 drag = drag_on_last_item();
    if (drag.x != 0.0F) screen.game.shot().turn(-drag.x * kCueTurnPerUnit_rad);
}

void draw_power(Screen& screen) {
    ShotControl& shot = screen.game.shot();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Power");
    ImGui::SameLine(kWordsBeside * screen.scale);
    double power = shot.shot().power;
    ImGui::SetNextItemWidth(90.0F * screen.scale);
    if (ImGui::InputDouble("##power", &power, 0.0, 0.0, "%.2f")) shot.set_power(power);
    screen.controls.note("Power");
    ImGui::PushButtonRepeat(true);
    ImGui::SameLine();
    if (ImGui::ArrowButton("##more", ImGuiDir_Up)) shot.step_power(1);
    screen.controls.note("Power Up");
    ImGui::SameLine(0.0F, 3.0F);
    if (ImGui::ArrowButton("##less", ImGuiDir_Down)) shot.step_power(-1);
    screen.controls.note("Power Down");
    ImGui::PopButtonRepeat();
}

/// A cue ball seen from behind the cue: click where the tip shall meet it.
void draw_spin(Screen& screen) {
    ShotControl& shot = screen.game.shot();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = kSpinPicture * screen.scale;
    ImGui::InvisibleButton("spin", {side, side});
    screen.controls.note("Spin");
    const float radius = side / 2;
    const ImVec2 middle{corner.x + radius, corner.y + radius};
    if (ImGui::IsItemActive()) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        shot.set_tip({(middle.x - mouse.x) / radius, (middle.y - mouse.y) / radius});
    }
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddCircleFilled(middle, radius - 1, IM_COL32(240, 236, 222, 255), 48);
    draw.AddCircle(middle, radius * static_cast<float>(kMaxTipOffset), IM_COL32(0, 0, 0, 60), 48);
    draw.AddLine({middle.x - radius, middle.y}, {middle.x + radius, middle.y},
                 IM_COL32(0, 0, 0, 30));
    draw.AddLine({middle.x, middle.y - radius}, {middle.x, middle.y + radius},
                 IM_COL32(0, 0, 0, 30));
    const ImVec2 tip{middle.x - radius * static_cast<float>(shot.shot().tip_left),
                     middle.y - radius * static_cast<float>(shot.shot().tip_up)};
    draw.AddCircleFilled(tip, 6.0F * screen.scale, IM_COL32(190, 40, 40, 255), 24);
}

void draw_strike_point(Screen& screen) {
    draw_spin(screen);
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::TextUnformatted("Spin");
    if (ImGui::Button("Center")) screen.game.shot().set_tip({});
    screen.controls.note("Center Spin");
    ImGui::TextUnformatted("Elevation");
    auto degrees = static_cast<float>(screen.game.shot().shot().elevation_rad / kDegree);
    ImGui::SetNextItemWidth(full_width());
    if (ImGui::SliderFloat("##elevation", &degrees, 0.0F, 85.0F, "%.0f deg")) {
        screen.game.shot().set_elevation(degrees * kDegree);
    }
    screen.controls.note("Elevation");
    ImGui::EndGroup();
}

std::string words_of(const Screen& screen) {
    const model::Call& call = screen.game.shot().call();
    if (screen.called_ball) {
        return fmt::format("{}: click its pocket", screen.called_ball->number);
    }
    if (const auto* called = std::get_if<model::CalledBall>(&call)) {
        return fmt::format("{} in pocket {}", called->ball.number, called->pocket.number + 1);
    }
    if (std::holds_alternative<model::Safety>(call)) return "safety";
    if (std::holds_alternative<model::PushOut>(call)) return "push-out";
    return "click a ball, then a pocket";
}

template <class Said>
void draw_said(Screen& screen, const char* name) {
    ShotControl& shot = screen.game.shot();
    const bool is_said = std::holds_alternative<Said>(shot.call());
    if (is_said) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    }
    if (ImGui::Button(name)) {
        screen.called_ball.reset();
        shot.set_call(is_said ? model::Call{} : model::Call{Said{}});
    }
    if (is_said) ImGui::PopStyleColor();
    screen.controls.note(name);
}

void draw_call(Screen& screen) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Call");
    ImGui::SameLine(kWordsBeside * screen.scale);
    ImGui::TextColored(colors::kQuiet, "%s", words_of(screen).c_str());
    screen.controls.note("Call");
    draw_said<model::Safety>(screen, "Safety");
    ImGui::SameLine();
    draw_said<model::PushOut>(screen, "Push-out");
    ImGui::SameLine();
    if (ImGui::Button("No call")) {
        screen.called_ball.reset();
        screen.game.shot().set_call(model::NoCall{});
    }
    screen.controls.note("No Call");
}

void draw_shoot(Screen& screen) {
    const bool may_shoot = screen.game.acting() && screen.game.cue_ball_m();
    ImGui::BeginDisabled(!may_shoot);
    ImGui::PushFont(screen.letters.large);
    if (ImGui::Button("Shoot", {full_width(), 0.0F})) screen.game.shoot();
    ImGui::PopFont();
    ImGui::EndDisabled();
    screen.controls.note("Shoot");
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
    ImGui::GetWindowDrawList()->AddText({cross.x + reach + gap, middle.y - size.y / 2}, kInk,
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
    draw_rotate_cue(screen);
    draw_shoot(screen);
    draw_power(screen);
    draw_strike_point(screen);
    draw_call(screen);
    group(screen, "Camera");
    draw_camera(screen);
    group(screen, "Follow a Ball");
    draw_followed(screen);
    draw_zoom(screen);
    ImGui::End();
}

}  // namespace billiards::client
