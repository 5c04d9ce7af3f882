// Takes clicks and drags on the panel's first group; changes the shot and the call.
#include "client/ui/panel_parts.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace billiards::client {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kCueTurnPerUnit_rad = 0.1 * kDegree;
constexpr float kSpinPicture = 92.0F;
constexpr float kWordsBeside = 74.0F;  ///< Where a row's control begins, right of its name.

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
void draw_said(Screen& screen, const char* name, bool is_allowed) {
    ShotControl& shot = screen.game.shot();
    const bool is_said = std::holds_alternative<Said>(shot.call());
    if (is_said) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    }
    ImGui::BeginDisabled(!is_allowed);
    if (ImGui::Button(name)) {
        screen.called_ball.reset();
        shot.set_call(is_said ? model::Call{} : model::Call{Said{}});
    }
    ImGui::EndDisabled();
    if (is_said) ImGui::PopStyleColor();
    screen.controls.note(name);
}

void draw_call(Screen& screen, const Offered& offered) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Call");
    ImGui::SameLine(kWordsBeside * screen.scale);
    ImGui::TextColored(colors::kQuiet, "%s", words_of(screen).c_str());
    screen.controls.note("Call");
    draw_said<model::Safety>(screen, "Safety", offered.safety);
    ImGui::SameLine();
    draw_said<model::PushOut>(screen, "Push-out", offered.push_out);
    ImGui::SameLine();
    ImGui::BeginDisabled(!offered.shoot);
    if (ImGui::Button("No call")) {
        screen.called_ball.reset();
        screen.game.shot().set_call(model::NoCall{});
    }
    ImGui::EndDisabled();
    screen.controls.note("No Call");
}

void draw_shoot(Screen& screen, const Offered& offered) {
    const bool may_shoot = offered.shoot && screen.game.cue_ball_m();
    ImGui::BeginDisabled(!may_shoot);
    ImGui::PushFont(screen.letters.large);
    if (ImGui::Button("Shoot", {full_width(), 0.0F})) screen.game.shoot();
    ImGui::PopFont();
    ImGui::EndDisabled();
    screen.controls.note("Shoot");
}

}  // namespace

ImU32 ink() {
    return ImGui::ColorConvertFloat4ToU32(colors::kText);
}

float full_width() {
    return ImGui::GetContentRegionAvail().x;
}

void draw_arrow(const Screen& screen, const ImVec2& from, const ImVec2& to) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const ImVec2 along{(to.x - from.x) / length, (to.y - from.y) / length};
    const float head = 5.0F * screen.scale;
    const ImVec2 neck{to.x - head * along.x, to.y - head * along.y};
    const ImVec2 aside{-0.8F * head * along.y, 0.8F * head * along.x};
    draw.AddLine(from, neck, ink(), 1.6F * screen.scale);
    draw.AddTriangleFilled(to, {neck.x + aside.x, neck.y + aside.y},
                           {neck.x - aside.x, neck.y - aside.y}, ink());
}

ImVec2 middle_of_last_item() {
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    return {(from.x + to.x) / 2, (from.y + to.y) / 2};
}

ImVec2 drag_on_last_item() {
    const bool is_dragged = ImGui::IsItemActive() && !ImGui::IsItemActivated();
    return is_dragged ? ImGui::GetIO().MouseDelta : ImVec2{0.0F, 0.0F};
}

void draw_cue_group(Screen& screen) {
    const Offered offered = screen.game.offered(screen.now);
    draw_rotate_cue(screen);
    draw_shoot(screen, offered);
    draw_power(screen);
    draw_strike_point(screen);
    draw_call(screen, offered);
}

}  // namespace billiards::client
