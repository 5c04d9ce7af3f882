// Takes the tables of a server, as they change; draws them in rows to be clicked.
#include "client/play/information.h"
#include "client/ui/menu_parts.h"
#include "client/ui/ways.h"
#include "common/protocol/limits.h"

#include <algorithm>
#include <fmt/format.h>

namespace billiards::client {

namespace {

constexpr float kListWidth = 760.0F;
constexpr float kListHeight = 260.0F;
constexpr float kRowHeight = 30.0F;
// Where a row's words begin, of the list's width.
constexpr float kGameAt = 0.24F;
constexpr float kPlayersAt = 0.34F;
constexpr float kRaceAt = 0.70F;
constexpr float kStateAt = 0.81F;
constexpr std::size_t kMostDigits = 10;  ///< Of a table's number.

/// Cut off where the next word of the row begins.
void draw_word(const Screen& screen, const ImVec2& row, float from, float to,
               const std::string& word, const ImVec4& color) {
    const float width = kListWidth * screen.scale;
    const ImVec2 corner{row.x + from * width, row.y};
    const ImVec4 limits{corner.x, row.y, row.x + to * width - 6.0F * screen.scale,
                        row.y + kRowHeight * screen.scale};
    const float down = (kRowHeight * screen.scale - ImGui::GetTextLineHeight()) / 2;
    ImGui::GetWindowDrawList()->AddText(nullptr, 0.0F, {corner.x, corner.y + down},
                                        ImGui::GetColorU32(color), word.c_str(), nullptr, 0.0F,
                                        &limits);
}

void draw_row(Screen& screen, const protocol::server::TableRow& row) {
    const bool watches = screen.menu.watches || !has_room(row);
    // Apart from its text: ImGui shows nothing after "##", and names may have that.
    const std::string id = fmt::format("##{}", row.table.value);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable(id.c_str(), false, 0, {0.0F, kRowHeight * screen.scale})) {
        const auto role = watches ? protocol::Role::Spectator : protocol::Role::Player;
        screen.game.join({.table = row.table, .role = role});
    }
    screen.controls.note(fmt::format("Table {}", row.table.value));
    const RowText text = text_of(row);
    draw_word(screen, corner, 0.005F, kGameAt, row.name, colors::kText);
    draw_word(screen, corner, kGameAt, kPlayersAt, text.game, colors::kQuiet);
    draw_word(screen, corner, kPlayersAt, kRaceAt, text.players, colors::kText);
    draw_word(screen, corner, kRaceAt, kStateAt, text.race, colors::kQuiet);
    draw_word(screen, corner, kStateAt, 0.985F, text.state,
              has_room(row) ? colors::kAccent : colors::kQuiet);
}

void draw_list(Screen& screen) {
    const ClientState& known = screen.game.known();
    ImGui::TextUnformatted(screen.menu.watches ? "Click a table to watch it."
                                               : "Click a table to play; a full one to watch.");
    ImGui::BeginChild("tables", {kListWidth * screen.scale, kListHeight * screen.scale}, true);
    for (const auto& row : known.tables) draw_row(screen, row);
    if (known.tables.empty()) ImGui::TextColored(colors::kQuiet, "There is no table yet.");
    ImGui::EndChild();
    if (!screen.menu.watches && wide_button(screen, "Open a new table")) {
        open(screen, MenuPage::Open);
    }
    if (wide_button(screen, "A private table")) open(screen, MenuPage::Private);
    say_refusal(screen);
}

void draw_unconnected(Screen& screen) {
    if (screen.game.lost().empty()) {
        ImGui::TextUnformatted("Connecting ...");
        return;
    }
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + kListWidth * screen.scale);
    ImGui::TextColored(colors::kWarning, "%s", screen.game.lost().c_str());
    ImGui::PopTextWrapPos();
    if (wide_button(screen, "Try again")) go_to_server(screen);
}

/// Somebody sits or stands there now: the menu is done.
bool has_arrived(Screen& screen) {
    if (!screen.game.known().table) return false;
    open(screen, MenuPage::Main);
    screen.menu.is_open = false;
    return true;
}

}  // namespace

void draw_tables_page(Screen& screen) {
    if (has_arrived(screen)) return;
    if (screen.game.is_connected()) {
        draw_list(screen);
    } else {
        draw_unconnected(screen);
    }
    if (wide_button(screen, "Back")) {
        screen.game.disconnect();
        screen.server.reset();
        open(screen, MenuPage::Main);
    }
}

void draw_private_page(Screen& screen) {
    if (has_arrived(screen)) return;
    quiet_line(screen, "Whoever sits there knows its number and its passcode.");
    bool goes = text_field(screen, "Number", screen.menu.table_number, kMostDigits);
    goes |= text_field(screen, "Passcode", screen.menu.passcode, protocol::kMaxPasscodeLength);
    goes |= wide_button(screen, screen.menu.watches ? "Watch there" : "Sit down");
    if (goes) go_to_private_table(screen);
    say_refusal(screen);
    draw_back(screen, MenuPage::Tables);
}

void draw_open_page(Screen& screen) {
    if (has_arrived(screen)) return;
    draw_wishes(screen);
    if (wide_button(screen, "Open the table")) open_table_there(screen);
    say_refusal(screen);
    draw_back(screen, MenuPage::Tables);
}

}  // namespace billiards::client
