// Takes clicks on the pages before a table: what to play, where to host; does it.
#include "client/ui/menu_parts.h"
#include "client/ui/ways.h"
#include "common/protocol/limits.h"

#include <array>

namespace billiards::client {

namespace {

constexpr std::size_t kMostDigits = 5;  ///< Of a port.
/// The longest name of a host has 253 letters; an invite has some forty more.
constexpr std::size_t kLongestAddress = 400;

void open_join(Screen& screen, bool watches) {
    open(screen, MenuPage::Join);
    screen.menu.watches = watches;
}

void draw_without_table(Screen& screen) {
    const bool waits = screen.kept && screen.kept->has_seat;
    if (waits && wide_button(screen, "Resume your match")) resume_match(screen);
    if (wide_button(screen, "Quick match")) open(screen, MenuPage::Quick);
    if (wide_button(screen, "Two players here")) play_two_here(screen);
    if (wide_button(screen, "Host a table")) open(screen, MenuPage::Host);
    if (half_button(screen, "Join", false)) open_join(screen, false);
    if (half_button(screen, "Watch", true)) open_join(screen, true);
    if (wide_button(screen, "Practice")) practise_here(screen);
}

}  // namespace

void draw_main_page(Screen& screen) {
    if (screen.game.known().table) return draw_table_page(screen);
    draw_without_table(screen);
    if (half_button(screen, "Help", false)) open(screen, MenuPage::Help);
    if (half_button(screen, "Quit", true)) screen.wants_to_quit = true;
}

void draw_host_page(Screen& screen) {
    MenuState& menu = screen.menu;
    bool opens = text_field(screen, "Your name", menu.name, protocol::kMaxNameLength);
    opens |= text_field(screen, "Port", menu.port, kMostDigits);
    draw_wishes(screen);
    check_box(screen, "Others may come over the network", "For others", menu.is_for_others);
    if (menu.is_for_others) {
        quiet_line(screen, "What is sent is not encrypted yet: for a network that you trust.");
    }
    opens |= wide_button(screen, "Open the table");
    if (opens) host_table(screen);
    draw_back(screen);
}

void draw_quick_page(Screen& screen) {
    quiet_line(screen, "Against whoever waits for this game at a server.");
    bool goes = text_field(screen, "Your name", screen.menu.name, protocol::kMaxNameLength);
    goes |= text_field(screen, "Server", screen.menu.address, kLongestAddress);
    draw_games(screen);
    goes |= wide_button(screen, "Find a match");
    if (goes) find_match(screen);
    draw_back(screen);
}

void draw_join_page(Screen& screen) {
    quiet_line(screen, "A server's address, or the invite that somebody sent you.");
    bool connects = text_field(screen, "Your name", screen.menu.name, protocol::kMaxNameLength);
    connects |= text_field(screen, "Server", screen.menu.address, kLongestAddress);
    connects |= wide_button(screen, "Connect");
    if (connects) go_to_server(screen);
    draw_back(screen);
}

void draw_help_page(Screen& screen) {
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
        Line{"Practice", "drag any ball; U undo; the rest is at the upper edge"},
        Line{"Eye", "right button and drag; Shift and wheel; O from above; V next view"},
        Line{"Other",
             "Z skip the roll, T aim line, Enter chat, F1 help, F11 full screen, Esc menu"}};
    for (const auto& [what, how] : kLines) {
        ImGui::TextColored(colors::kAccent, "%s", what);
        ImGui::SameLine(180.0F * screen.scale);
        ImGui::TextUnformatted(how);
    }
    draw_back(screen);
}

}  // namespace billiards::client
