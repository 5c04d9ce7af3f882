// Takes what is said at the table; draws its last lines at the lower left, and takes one to be
// said. A click on a name mutes it.
#include "client/ui/hud_parts.h"
#include "client/ui/text_input.h"
#include "common/protocol/limits.h"

#include <algorithm>

namespace billiards::client {

namespace {

constexpr std::size_t kLinesShown = 5;
constexpr float kWidth = 330.0F;
/// Of the lines together, unless it is one: they lie over the table.
constexpr float kMostHeight = 130.0F;

bool is_alone(const TableView& table) {
    return table.my_seats.size() == 2 && table.row.spectators == 0;
}

/// It stands below its speaker's name, not beside it.
bool is_long(const Screen& screen, const ChatLine& line) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    return ImGui::CalcTextSize(line.name.c_str()).x + gap +
               ImGui::CalcTextSize(line.text.c_str()).x >
           kWidth * screen.scale;
}

float height_of(const Screen& screen, const ChatLine& line) {
    if (!is_long(screen, line)) return ImGui::GetTextLineHeightWithSpacing();
    const float width = kWidth * screen.scale;
    return ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y +
           ImGui::CalcTextSize(line.text.c_str(), nullptr, false, width).y;
}

void draw_line(Screen& screen, const ChatLine& line, std::size_t number) {
    // Apart from its text: ImGui shows nothing after "##", and names may have that.
    ImGui::PushID(static_cast<int>(number));
    const bool is_mine = line.name == screen.game.known().name;
    ImGui::TextColored(colors::kAccent, "%s", line.name.c_str());
    if (!is_mine && ImGui::IsItemClicked()) screen.game.mute(line.name);
    if (!is_mine) screen.controls.note("Mute " + line.name);
    if (!is_mine && ImGui::IsItemHovered()) ImGui::SetTooltip("Click to mute");
    if (!is_long(screen, line)) ImGui::SameLine();
    ImGui::TextUnformatted(line.text.c_str());
    ImGui::PopID();
}

/// The newest that have room.
void draw_lines(Screen& screen) {
    const auto& chat = screen.game.known().chat;
    std::size_t first = chat.size();
    float height = 0.0F;
    while (first > 0 && chat.size() - first < kLinesShown) {
        height += height_of(screen, chat[first - 1]);
        if (height > kMostHeight * screen.scale && first < chat.size()) break;
        --first;
    }
    // As wide as it is meant to be: a strip that fits its words would ask them how wide they are.
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + kWidth * screen.scale);
    for (std::size_t i = first; i < chat.size(); ++i) draw_line(screen, chat[i], i);
    ImGui::PopTextWrapPos();
}

void draw_muted(Screen& screen) {
    for (const std::string& name : screen.game.known().muted) {
        ImGui::PushID(name.c_str());
        ImGui::TextColored(colors::kQuiet, "%s is muted", name.c_str());
        ImGui::SameLine();
        const bool is_clicked = ImGui::SmallButton("hear again");
        screen.controls.note("Hear " + name);
        ImGui::PopID();
        if (!is_clicked) continue;
        screen.game.unmute(std::string(name));
        return;
    }
}

void draw_field(Screen& screen) {
    TalkState& talk = screen.talk;
    if (std::exchange(talk.takes_focus, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(kWidth * screen.scale);
    const bool is_entered =
        text_input("##say", "say something; Enter sends it", talk.text, protocol::kMaxChatLength);
    screen.controls.note("Say");
    const bool is_done = is_entered || ImGui::IsItemDeactivated();
    if (is_entered && !talk.text.empty()) {
        screen.game.chat(talk.text);
        talk.text.clear();
    }
    if (is_done) talk.is_open = false;
}

}  // namespace

void draw_talk(Screen& screen, const TableView& table) {
    if (is_alone(table) && screen.game.known().chat.empty()) return;
    const float margin = kStripMargin * screen.scale;
    const float height = ImGui::GetIO().DisplaySize.y;
    ImGui::SetNextWindowPos({margin, height - margin}, ImGuiCond_Always, {0.0F, 1.0F});
    ImGui::SetNextWindowBgAlpha(screen.talk.is_open ? 0.85F : 0.55F);
    ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {(kWidth + 40.0F) * screen.scale, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8.0F * screen.scale);
    ImGui::Begin("talk", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    ImGui::PushFont(screen.letters.small);
    draw_lines(screen);
    if (screen.talk.is_open) {
        draw_muted(screen);
        draw_field(screen);
    } else {
        if (ImGui::SmallButton("Chat")) screen.talk.is_open = screen.talk.takes_focus = true;
        screen.controls.note("Chat");
    }
    ImGui::PopFont();
    ImGui::End();
}

}  // namespace billiards::client
