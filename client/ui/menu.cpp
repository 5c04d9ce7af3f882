// Takes clicks in the menu; draws its frame and the page that is open. What goes wrong is said on
// the page where it was asked.
#include "client/ui/menu.h"

#include "client/ui/menu_parts.h"

#include <SDL.h>

namespace billiards::client {

namespace {

constexpr float kTroubleWidth = 420.0F;

void draw_page(Screen& screen) {
    switch (screen.menu.page) {
        case MenuPage::Main:
            return draw_main_page(screen);
        case MenuPage::Host:
            return draw_host_page(screen);
        case MenuPage::Join:
            return draw_join_page(screen);
        case MenuPage::Tables:
            return draw_tables_page(screen);
        case MenuPage::Help:
            return draw_help_page(screen);
        case MenuPage::Quick:
            return draw_quick_page(screen);
        case MenuPage::Private:
            return draw_private_page(screen);
        case MenuPage::Open:
            return draw_open_page(screen);
        case MenuPage::Table:
            return draw_main_page(screen);
    }
}

/// Without a table and with nothing that comes back by itself, there is only the menu.
void open_where_nothing_is_left(Screen& screen) {
    const Game& game = screen.game;
    if (game.known().table || screen.menu.is_open) return;
    if (!game.is_connected() && !game.lost().empty() && !game.is_coming_back()) {
        screen.menu.trouble = "No connection: " + game.lost();
        screen.menu.is_open = true;
    } else if (game.is_connected() && !game.refusal().empty()) {
        screen.menu.page = MenuPage::Tables;
        screen.menu.is_open = true;
    }
}

void begin_menu(const Screen& screen) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float middle = screen.table_width(display.x) / 2;
    ImGui::SetNextWindowPos({middle, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.88F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {28.0F * screen.scale, 18.0F * screen.scale});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 10.0F * screen.scale);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8.0F * screen.scale, 9.0F * screen.scale});
    ImGui::Begin("menu", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove);
}

}  // namespace

void draw_menu(Screen& screen) {
    const MenuPage page = screen.menu.page;
    open_where_nothing_is_left(screen);
    if (screen.game.known().table && ImGui::IsKeyPressed(SDL_SCANCODE_ESCAPE, false)) {
        screen.menu.is_open = false;
    }
    if (!screen.menu.is_open) return;
    begin_menu(screen);
    ImGui::PushFont(screen.letters.title);
    ImGui::TextUnformatted("gl-billiards");
    ImGui::PopFont();
    draw_page(screen);
    if (!screen.menu.trouble.empty() && page == screen.menu.page) {
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + kTroubleWidth * screen.scale);
        ImGui::TextColored(colors::kWarning, "%s", screen.menu.trouble.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace billiards::client
