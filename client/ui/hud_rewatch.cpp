// Takes a match that is watched; draws the way to its start and back at the lower edge.
#include "client/ui/hud_parts.h"

#include <fmt/format.h>

namespace billiards::client {

namespace {

constexpr float kFromBottom = 58.0F;

bool button(Screen& screen, const char* name) {
    const bool is_clicked = ImGui::Button(name);
    screen.controls.note(name);
    return is_clicked;
}

void draw_way(Screen& screen, Rewatch& rewatch) {
    if (button(screen, "Previous shot")) rewatch.previous_shot(screen.now);
    ImGui::SameLine();
    if (rewatch.is_paused()) {
        if (button(screen, "Go on")) rewatch.go_on();
    } else if (button(screen, "Pause")) {
        rewatch.pause();
    }
    ImGui::SameLine();
    if (button(screen, "Next shot")) rewatch.next_shot(screen.now);
    ImGui::SameLine();
    ImGui::TextColored(colors::kQuiet, "%s",
                       fmt::format("{} of {}", rewatch.step() + 1, rewatch.steps()).c_str());
    ImGui::SameLine();
    if (button(screen, "Live")) screen.game.watch_live();
}

}  // namespace

void draw_rewatch(Screen& screen, const TableView& table) {
    Rewatch* rewatch = screen.game.rewatch();
    const bool may_begin = table.match && table.my_seats.empty();
    if (rewatch == nullptr && !may_begin) return;
    const float height = ImGui::GetIO().DisplaySize.y;
    begin_strip(screen, "rewatch", height - kFromBottom * screen.scale, ImGuiWindowFlags_None);
    if (rewatch != nullptr) {
        draw_way(screen, *rewatch);
    } else if (button(screen, "From the start")) {
        screen.game.watch_from_start();
    }
    ImGui::End();
}

}  // namespace billiards::client
