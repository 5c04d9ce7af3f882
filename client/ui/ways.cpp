// Takes a screen; does what its menu was asked for, and keeps what the next start needs.
#include "client/ui/ways.h"

#include "client/local/own_address.h"
#include "client/play/player_name.h"
#include "client/play/way_in.h"

#include <charconv>
#include <fmt/format.h>
#include <imgui.h>
#include <stdexcept>

namespace billiards::client {

namespace {

template <class Number>
std::optional<Number> number_of(const std::string& text) {
    Number number = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    return parsed.ec == std::errc() && parsed.ptr == end ? std::optional(number) : std::nullopt;
}

protocol::client::CreateTable table_of(const MenuState& menu, protocol::Role role) {
    protocol::client::CreateTable table;
    table.name = menu.name + "'s table";
    table.role = role;
    table.settings = settings_of(menu.table);
    table.is_private = menu.table.is_private;
    if (table.is_private) table.passcode = menu.table.passcode;
    return table;
}

/// Says so where a server would refuse the name.
bool has_name(MenuState& menu) {
    if (is_player_name(menu.name)) return true;
    menu.trouble = fmt::format("\"{}\": {}", menu.name, kPlayerNameRule);
    return false;
}

/// Where the session is; to be kept as soon as there is a token for it.
void begin_session(Screen& screen, const KeptSession& session, bool is_kept = false) {
    screen.is_session_kept = is_kept;
    screen.session = session;
    screen.session.name = screen.menu.name;
    screen.session.token = {};
    screen.session.has_seat = false;
}

bool start_server(Screen& screen, const LocalServerOptions& options) {
    MenuState& menu = screen.menu;
    if (is_profile_taken(screen)) return false;
    try {
        screen.game.disconnect();
        screen.server.reset();
        screen.server = std::make_unique<LocalServer>(options);
    } catch (const std::exception& error) {
        menu.trouble = error.what();
        return false;
    }
    return true;
}

LocalServerOptions server_of(const Screen& screen, const KeptSession& session) {
    if (session.where == Whereabouts::Here) return {.data = screen.profile.folder() / "here"};
    return {.data = screen.profile.folder() / "host",
            .port = session.port,
            .is_for_others = session.is_for_others};
}

/// Starts a server in this process and takes a place at a new table there.
void play_here(Screen& screen, const KeptSession& session,
               const protocol::client::CreateTable& table) {
    if (!has_name(screen.menu) || !start_server(screen, server_of(screen, session))) return;
    begin_session(screen, session);
    screen.game.connect(screen.server->address(), screen.menu.name, OpenTable{table});
    screen.menu.is_open = false;
}

/// As whom the profile knows this server.
std::optional<protocol::ResumeToken> token_for(Screen& screen, const ServerAddress& address) {
    const auto& kept = screen.kept;
    const bool is_known = kept && kept->where == Whereabouts::Elsewhere &&
                          kept->address == to_text(address) && kept->name == screen.menu.name;
    return is_known && screen.profile.is_ours() ? std::optional(kept->token) : std::nullopt;
}

void connect(Screen& screen, const ServerAddress& address, Errand errand) {
    const auto token = token_for(screen, address);
    begin_session(screen, {.where = Whereabouts::Elsewhere, .address = to_text(address)},
                  token.has_value());
    screen.game.connect(address, screen.menu.name, std::move(errand), token);
    screen.menu.page = MenuPage::Tables;
    screen.menu.trouble.clear();
}

/// Says so where the menu's address is none.
std::optional<WayIn> way_in_of(MenuState& menu) {
    const auto role = menu.watches ? protocol::Role::Spectator : protocol::Role::Player;
    const auto way = way_in(menu.address, role);
    if (!way) {
        menu.trouble =
            fmt::format("\"{}\" is no address; one looks like example.org:4747", menu.address);
    }
    return way;
}

void keep_session(Screen& screen) {
    const ClientState& known = screen.game.known();
    if (!screen.game.is_connected() || !known.token || screen.session.name.empty()) return;
    KeptSession now = screen.session;
    now.token = *known.token;
    now.has_seat = known.table && !known.table->my_seats.empty();
    if (screen.kept == now) return;
    // Who looks around elsewhere has not given up the match that waits.
    const bool waits_elsewhere = screen.kept && screen.kept->has_seat && !screen.is_session_kept;
    if ((waits_elsewhere && !now.has_seat) || !screen.profile.is_ours()) return;
    screen.profile.keep(now);
    screen.kept = now;
    screen.is_session_kept = true;
}

void end_left_server(Screen& screen) {
    const bool is_idle = screen.server && screen.game.is_connected() && !screen.game.known().table;
    if (!is_idle || !screen.has_left_own_table) return;
    screen.has_left_own_table = false;
    screen.game.disconnect();
    screen.server.reset();
}

void copy_invite(Screen& screen) {
    const auto& made = screen.game.invite();
    if (!screen.copies_invite || !made) return;
    screen.copies_invite = false;
    screen.copied = link_of(*made, address_for_others(screen));
    ImGui::SetClipboardText(screen.copied.c_str());
}

}  // namespace

void play_two_here(Screen& screen) {
    screen.menu.table.is_private = false;
    play_here(screen, {.where = Whereabouts::Here},
              table_of(screen.menu, protocol::Role::BothSeats));
}

void practise_here(Screen& screen) {
    auto table = table_of(screen.menu, protocol::Role::BothSeats);
    table.settings.game = rules::Game::Practice;
    table.is_private = false;
    play_here(screen, {.where = Whereabouts::Here}, table);
}

void host_table(Screen& screen) {
    const auto port = number_of<std::uint16_t>(screen.menu.port);
    if (!port) {
        screen.menu.trouble = "The port is a number from 0 to 65535.";
        return;
    }
    play_here(
        screen,
        {.where = Whereabouts::Hosted, .port = *port, .is_for_others = screen.menu.is_for_others},
        table_of(screen.menu, protocol::Role::Player));
}

void go_to_server(Screen& screen) {
    if (!has_name(screen.menu)) return;
    const auto way = way_in_of(screen.menu);
    if (!way) return;
    connect(screen, way->address, way->join ? Errand(GoToTable{*way->join}) : LookAround{});
}

void find_match(Screen& screen) {
    if (!has_name(screen.menu)) return;
    const auto way = way_in_of(screen.menu);
    if (!way) return;
    connect(screen, way->address,
            PlayWhoeverWaits{static_cast<rules::Game>(screen.menu.table.game)});
}

void resume_match(Screen& screen) {
    if (!screen.kept) return;
    const KeptSession kept = *screen.kept;
    screen.menu.name = kept.name;
    if (kept.where == Whereabouts::Elsewhere) {
        screen.menu.address = kept.address;
        const auto way = way_in_of(screen.menu);
        if (way) connect(screen, way->address, GoOn{});
        return;
    }
    if (!start_server(screen, server_of(screen, kept))) return;
    begin_session(screen, kept, true);
    screen.game.connect(screen.server->address(), kept.name, GoOn{}, kept.token);
    screen.menu.page = MenuPage::Tables;
}

void open_table_there(Screen& screen) {
    screen.game.open_table(table_of(screen.menu, protocol::Role::Player));
}

void go_to_private_table(Screen& screen) {
    MenuState& menu = screen.menu;
    const auto number = number_of<std::uint32_t>(menu.table_number);
    if (!number) {
        menu.trouble = "A table's number is on the screen of whoever sits there.";
        return;
    }
    menu.trouble.clear();
    const auto role = menu.watches ? protocol::Role::Spectator : protocol::Role::Player;
    screen.game.join({.table = {*number}, .role = role, .passcode = menu.passcode});
}

void leave_table(Screen& screen) {
    screen.has_left_own_table = screen.server != nullptr;
    screen.game.leave_table();
    screen.menu.page = screen.server ? MenuPage::Main : MenuPage::Tables;
}

void follow_up(Screen& screen) {
    keep_session(screen);
    end_left_server(screen);
    copy_invite(screen);
    if (!screen.game.known().table) screen.copied.clear();
}

bool is_profile_taken(Screen& screen) {
    if (screen.profile.is_ours()) return false;
    screen.menu.trouble =
        "Another window of yours plays under this profile: start this one with --profile NAME.";
    return true;
}

match::Settings settings_of(const TableWishes& wishes, match::Settings settings) {
    settings.game = static_cast<rules::Game>(wishes.game);
    settings.race_to = wishes.race_to;
    settings.table = static_cast<model::TableSize>(wishes.table_size);
    settings.spectator_delay_s = wishes.delay_s;
    return settings;
}

ServerAddress address_for_others(const Screen& screen) {
    if (!screen.server) {
        return parse_address(screen.session.address).value_or(ServerAddress{});
    }
    ServerAddress address = screen.server->address();
    if (screen.session.is_for_others) address.host = own_address();
    return address;
}

}  // namespace billiards::client
