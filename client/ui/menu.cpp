// Takes clicks in the menu; starts servers, connects, sits down. What goes wrong is said on the
// page where it was asked.
#include "client/ui/menu.h"

#include "common/protocol/limits.h"
#include "common/protocol/text.h"

#include <SDL.h>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <imgui_stdlib.h>
#include <stdexcept>

namespace billiards::client {

namespace {

constexpr std::array kTableSizes{"7 ft", "8 ft", "9 ft"};
constexpr std::array kGames{"8-ball", "9-ball", "10-ball", "14.1"};

ImVec2 wide(const Screen& screen) {
    return {340.0F * screen.scale, 44.0F * screen.scale};
}

/// True where it was clicked.
bool wide_button(Screen& screen, const char* name) {
    const bool clicked = ImGui::Button(name, wide(screen));
    screen.controls.note(name);
    return clicked;
}

void open(Screen& screen, MenuPage page) {
    screen.menu.page = page;
    screen.menu.trouble.clear();
}

std::optional<std::uint16_t> port_of(const std::string& text) {
    std::uint16_t port = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, port);
    return parsed.ec == std::errc() && parsed.ptr == end ? std::optional(port) : std::nullopt;
}

protocol::client::CreateTable table_of(const MenuState& menu, protocol::Role role) {
    protocol::client::CreateTable table;
    table.name = menu.name + "'s table";
    table.role = role;
    table.settings.game = static_cast<rules::Game>(menu.game);
    table.settings.race_to = menu.race_to;
    table.settings.table = static_cast<model::TableSize>(menu.table_size);
    return table;
}

/// Says so where a server would refuse the name.
bool has_name(MenuState& menu) {
    const auto shown = protocol::clean_text(menu.name, protocol::kMaxNameLength);
    if (shown && !shown->empty()) return true;
    menu.trouble = fmt::format("\"{}\" is no name; one has 1 to {} letters or signs.", menu.name,
                               protocol::kMaxNameLength);
    return false;
}

/// Starts a server in this process and sits down at a new table there.
void start_server(Screen& screen, const LocalServerOptions& options, protocol::Role role) {
    MenuState& menu = screen.menu;
    if (!has_name(menu)) return;
    try {
        screen.game.disconnect();
        screen.server.reset();
        screen.server = std::make_unique<LocalServer>(options);
    } catch (const std::exception& error) {
        menu.trouble = error.what();
        return;
    }
    screen.game.connect(screen.server->address(), menu.name, OpenTable{table_of(menu, role)});
    menu.is_open = false;
}

void go_to_server(Screen& screen) {
    MenuState& menu = screen.menu;
    if (!has_name(menu)) return;
    const auto address = parse_address(menu.address);
    if (!address) {
        menu.trouble =
            fmt::format("\"{}\" is no address; one looks like example.org:4747", menu.address);
        return;
    }
    screen.game.connect(*address, menu.name, LookAround{});
    open(screen, MenuPage::Tables);
}

void leave(Screen& screen) {
    screen.game.disconnect();
    screen.server.reset();
}

/// True where Enter ends it: the page does then what it is for.
bool text_field(Screen& screen, const char* name, std::string& text) {
    ImGui::TextUnformatted(name);
    ImGui::SetNextItemWidth(wide(screen).x);
    const bool is_entered = ImGui::InputText(fmt::format("##{}", name).c_str(), &text,
                                             ImGuiInputTextFlags_EnterReturnsTrue);
    screen.controls.note(name);
    return is_entered;
}

/// One of a few words, side by side.
template <std::size_t kWords>
void draw_row_of_words(Screen& screen, const char* title,
                       const std::array<const char*, kWords>& words, int& chosen) {
    ImGui::TextUnformatted(title);
    for (std::size_t i = 0; i < kWords; ++i) {
        if (i > 0) ImGui::SameLine();
        ImGui::RadioButton(words[i], &chosen, static_cast<int>(i));
        screen.controls.note(words[i]);
    }
}

void draw_settings(Screen& screen) {
    MenuState& menu = screen.menu;
    draw_row_of_words(screen, "Game", kGames, menu.game);
    ImGui::TextUnformatted("Race to");
    ImGui::SetNextItemWidth(wide(screen).x);
    ImGui::SliderInt("##race", &menu.race_to, 1, 15, "%d racks");
    screen.controls.note("Race to");
    draw_row_of_words(screen, "Table", kTableSizes, menu.table_size);
}

void draw_at_table(Screen& screen) {
    const TableView& table = *screen.game.known().table;
    const bool is_playing = table.match && table.match->stage != match::Stage::Over;
    if (wide_button(screen, "Back to the table")) screen.menu.is_open = false;
    if (is_playing && !table.my_seats.empty()) {
        if (wide_button(screen, "Concede the match")) screen.game.concede();
    } else if (wide_button(screen, "Leave the table")) {
        leave(screen);
    }
}

void draw_main(Screen& screen) {
    if (screen.game.known().table) {
        draw_at_table(screen);
    } else {
        if (wide_button(screen, "Two players here")) play_two_here(screen);
        if (wide_button(screen, "Host a table")) open(screen, MenuPage::Host);
        if (wide_button(screen, "Join")) {
            open(screen, MenuPage::Join);
            screen.menu.watches = false;
        }
        if (wide_button(screen, "Watch")) {
            open(screen, MenuPage::Join);
            screen.menu.watches = true;
        }
    }
    if (wide_button(screen, "Help")) open(screen, MenuPage::Help);
    if (wide_button(screen, "Quit")) screen.wants_to_quit = true;
}

void draw_back(Screen& screen) {
    if (wide_button(screen, "Back")) open(screen, MenuPage::Main);
}

void draw_host(Screen& screen) {
    MenuState& menu = screen.menu;
    bool opens = text_field(screen, "Your name", menu.name);
    opens |= text_field(screen, "Port", menu.port);
    draw_settings(screen);
    ImGui::Checkbox("Others may come over the network", &menu.is_for_others);
    screen.controls.note("For others");
    if (menu.is_for_others) {
        ImGui::TextColored(colors::kQuiet,
                           "What is sent is not encrypted yet: for a network that you trust.");
    }
    opens |= wide_button(screen, "Open the table");
    if (opens) {
        if (const auto port = port_of(menu.port)) {
            start_server(
                screen,
                {.data = screen.data / "host", .port = *port, .is_for_others = menu.is_for_others},
                protocol::Role::Player);
        } else {
            menu.trouble = "The port is a number from 0 to 65535.";
        }
    }
    draw_back(screen);
}

void draw_join(Screen& screen) {
    bool connects = text_field(screen, "Your name", screen.menu.name);
    connects |= text_field(screen, "Server", screen.menu.address);
    connects |= wide_button(screen, "Connect");
    if (connects) go_to_server(screen);
    draw_back(screen);
}

void draw_row(Screen& screen, const protocol::server::TableRow& row) {
    using model::Seat;
    const auto name_of = [&](Seat seat) {
        return row.seats[seat].taken ? row.seats[seat].name : std::string("free");
    };
    const bool has_room = !row.seats[Seat::First].taken || !row.seats[Seat::Second].taken;
    const bool watches = screen.menu.watches || !has_room;
    const std::string text =
        fmt::format("{}:  {} {} - {} {}   race to {}, {} watching", row.name, name_of(Seat::First),
                    row.racks_won[Seat::First], row.racks_won[Seat::Second], name_of(Seat::Second),
                    row.settings.race_to, row.spectators);
    // Apart from its text: ImGui shows nothing after "##", and names may have that.
    const std::string id = fmt::format("##{}", row.table.value);
    const ImVec2 place = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable(id.c_str(), false, 0, {0.0F, 30.0F * screen.scale})) {
        screen.game.join(row.table, watches ? protocol::Role::Spectator : protocol::Role::Player);
    }
    ImGui::GetWindowDrawList()->AddText(place, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    screen.controls.note(fmt::format("Table {}", row.table.value));
}

void draw_tables(Screen& screen) {
    const ClientState& known = screen.game.known();
    if (known.table) {
        open(screen, MenuPage::Main);
        screen.menu.is_open = false;
        return;
    }
    if (!screen.game.is_connected()) {
        if (!screen.game.lost().empty()) {
            ImGui::TextColored(colors::kWarning, "%s", screen.game.lost().c_str());
            if (wide_button(screen, "Try again")) go_to_server(screen);
        } else {
            ImGui::TextUnformatted("Connecting ...");
        }
    } else {
        ImGui::TextUnformatted(screen.menu.watches ? "Click a table to watch it."
                                                   : "Click a table to play; a full one to watch.");
        ImGui::BeginChild("tables", {760.0F * screen.scale, 260.0F * screen.scale}, true);
        for (const auto& row : known.tables) draw_row(screen, row);
        if (known.tables.empty()) ImGui::TextColored(colors::kQuiet, "There is no table yet.");
        ImGui::EndChild();
        if (wide_button(screen, "Look again")) screen.game.list_tables();
        if (!screen.menu.watches && wide_button(screen, "Open a new table")) {
            screen.game.open_table(table_of(screen.menu, protocol::Role::Player));
        }
    }
    if (wide_button(screen, "Back")) {
        screen.game.disconnect();
        open(screen, MenuPage::Main);
    }
}

void draw_help(Screen& screen) {
    struct Line {
        const char* what;
        const char* how;
    };
    constexpr std::array kLines{
        Line{"Aim",
             "move the mouse; Ctrl: a tenth; left and right arrows: 0.03 degrees, Shift 0.23"},
        Line{"Shoot", "press the left button, pull back, let go; Esc or right button: not now"},
        Line{"Power", "wheel, or up and down arrows; then Space shoots"},
        Line{"Spin, elevation", "hold E, or B, and move the mouse; E twice: centre"},
        Line{"Cue ball in hand", "drag it, or arrows (Shift: ten times); Enter sets it down"},
        Line{"Call", "click a ball, then its pocket; C: nothing called"},
        Line{"Eye", "right button and drag; Shift and wheel; O from above; V next view"},
        Line{"Other", "Z skip the roll, T aim line, F1 help, F11 full screen, Esc menu"}};
    for (const auto& [what, how] : kLines) {
        ImGui::TextColored(colors::kAccent, "%s", what);
        ImGui::SameLine(180.0F * screen.scale);
        ImGui::TextUnformatted(how);
    }
    draw_back(screen);
}

void draw_page(Screen& screen) {
    switch (screen.menu.page) {
        case MenuPage::Main:
            return draw_main(screen);
        case MenuPage::Host:
            return draw_host(screen);
        case MenuPage::Join:
            return draw_join(screen);
        case MenuPage::Tables:
            return draw_tables(screen);
        case MenuPage::Help:
            return draw_help(screen);
    }
}

}  // namespace

void play_two_here(Screen& screen) {
    start_server(screen, {.data = screen.data / "here"}, protocol::Role::BothSeats);
}

void draw_menu(Screen& screen) {
    const MenuPage page = screen.menu.page;
    const bool has_gone = screen.game.known().table == std::nullopt &&
                          !screen.game.is_connected() && !screen.game.lost().empty() &&
                          !screen.game.is_coming_back();
    if (has_gone && !screen.menu.is_open) {
        screen.menu.trouble = "No connection: " + screen.game.lost();
        screen.menu.is_open = true;
    }
    if (screen.game.known().table && ImGui::IsKeyPressed(SDL_SCANCODE_ESCAPE, false)) {
        screen.menu.is_open = false;
    }
    if (!screen.menu.is_open) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float middle = screen.table_width(display.x) / 2;
    ImGui::SetNextWindowPos({middle, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.88F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {28.0F * screen.scale, 22.0F * screen.scale});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 10.0F * screen.scale);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8.0F * screen.scale, 10.0F * screen.scale});
    ImGui::Begin("menu", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove);
    ImGui::PushFont(screen.letters.title);
    ImGui::TextUnformatted("gl-billiards");
    ImGui::PopFont();
    ImGui::Dummy({0.0F, 6.0F * screen.scale});
    draw_page(screen);
    if (!screen.menu.trouble.empty() && page == screen.menu.page) {
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + 420.0F * screen.scale);
        ImGui::TextColored(colors::kWarning, "%s", screen.menu.trouble.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

}  // namespace billiards::client
