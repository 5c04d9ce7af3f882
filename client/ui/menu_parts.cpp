// Takes words; draws controls of the menu's width, and notes where they are.
#include "client/ui/menu_parts.h"

#include "client/ui/text_input.h"
#include "common/protocol/limits.h"

#include <fmt/format.h>

namespace billiards::client {

namespace {

constexpr float kWidth = 400.0F;
constexpr float kHeight = 40.0F;
constexpr int kMostRace = 15;
constexpr int kMostDelay_s = 120;
constexpr std::array kTableSizes{"7 ft", "8 ft", "9 ft"};
constexpr std::array kGames{"8-ball", "9-ball", "10-ball", "14.1"};  ///< As rules::Game.
constexpr float kNamesWidth = 0.24F;                                 ///< Of the menu's.

float width(const Screen& screen) {
    return kWidth * screen.scale;
}

/// What a line is about at its left, so that the controls stand below each other.
void begin_line(const Screen& screen, const char* name) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name);
    ImGui::SameLine(kNamesWidth * width(screen) + ImGui::GetStyle().WindowPadding.x);
    ImGui::SetNextItemWidth((1.0F - kNamesWidth) * width(screen));
}

void one_of(Screen& screen, const std::string& word, int& chosen, int value) {
    if (value > 0) ImGui::SameLine(0.0F, 8.0F * screen.scale);
    ImGui::RadioButton(word.c_str(), &chosen, value);
    screen.controls.note(word);
}

}  // namespace

bool wide_button(Screen& screen, const char* name) {
    const bool is_clicked = ImGui::Button(name, {width(screen), kHeight * screen.scale});
    screen.controls.note(name);
    return is_clicked;
}

bool half_button(Screen& screen, const char* name, bool is_second) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    if (is_second) ImGui::SameLine();
    const bool is_clicked =
        ImGui::Button(name, {(width(screen) - gap) / 2, kHeight * screen.scale});
    screen.controls.note(name);
    return is_clicked;
}

bool text_field(Screen& screen, const char* name, std::string& text, std::size_t most,
                const char* hint) {
    begin_line(screen, name);
    const bool is_entered = text_input(fmt::format("##{}", name).c_str(), hint, text, most);
    screen.controls.note(name);
    return is_entered;
}

void quiet_line(const Screen& screen, const char* text) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width(screen));
    ImGui::PushStyleColor(ImGuiCol_Text, colors::kQuiet);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
}

void check_box(Screen& screen, const char* text, const char* name, bool& value) {
    ImGui::Checkbox(text, &value);
    screen.controls.note(name);
}

void open(Screen& screen, MenuPage page) {
    screen.menu.page = page;
    screen.menu.trouble.clear();
    screen.game.forget_refusal();
}

void say_refusal(Screen& screen) {
    std::string text = screen.game.refusal();
    if (text.empty()) return;
    if (text[0] >= 'a' && text[0] <= 'z') text[0] -= 'a' - 'A';
    screen.menu.trouble = text + ".";
}

void draw_back(Screen& screen, MenuPage to) {
    if (wide_button(screen, "Back")) open(screen, to);
}

void draw_games(Screen& screen) {
    begin_line(screen, "Game");
    for (std::size_t i = 0; i < kGames.size(); ++i) {
        one_of(screen, kGames.at(i), screen.menu.table.game, static_cast<int>(i));
    }
}

void draw_wishes(Screen& screen) {
    TableWishes& wishes = screen.menu.table;
    draw_games(screen);
    begin_line(screen, "Race to");
    ImGui::SliderInt("##race", &wishes.race_to, 1, kMostRace, "%d racks");
    screen.controls.note("Race to");
    begin_line(screen, "Table");
    for (std::size_t i = 0; i < kTableSizes.size(); ++i) {
        one_of(screen, kTableSizes.at(i), wishes.table_size, static_cast<int>(i));
    }
    begin_line(screen, "Spectators");
    ImGui::SliderInt("##delay", &wishes.delay_s, 0, kMostDelay_s,
                     wishes.delay_s == 0 ? "see it at once" : "see it %d s late");
    screen.controls.note("Spectators");
    check_box(screen, "Private: by invite or passcode only", "Private", wishes.is_private);
    if (!wishes.is_private) return;
    text_field(
        screen, "Passcode", wishes.passcode, protocol::kMaxPasscodeLength,
        wishes.has_passcode ? "as it was, until a new one is typed" : "none: by invite only");
}

}  // namespace billiards::client
