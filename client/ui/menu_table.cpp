// Takes a table where somebody sits or stands; draws what can be done about it: give up, agree,
// leave, and what its owner decides.
#include "client/play/information.h"
#include "client/play/offered.h"
#include "client/ui/menu_parts.h"
#include "client/ui/ways.h"
#include "common/protocol/limits.h"

#include <fmt/format.h>

namespace billiards::client {

namespace {

void draw_agreements(Screen& screen, const Offered& offered) {
    if (offered.offer_draw && half_button(screen, "Offer a draw", false)) {
        screen.game.offer(match::OfferKind::Draw);
        screen.menu.is_open = false;
    }
    if (offered.offer_replay && half_button(screen, "Offer to re-rack", offered.offer_draw)) {
        screen.game.offer(match::OfferKind::Stalemate);
        screen.menu.is_open = false;
    }
    if (offered.claim_stalemate && wide_button(screen, "Claim a stalemate")) {
        screen.game.claim_stalemate();
        screen.menu.is_open = false;
    }
}

void draw_way_out(Screen& screen, const Offered& offered) {
    if (!offered.concede) {
        if (wide_button(screen, "Leave the table")) leave_table(screen);
        return;
    }
    const bool is_practice = screen.game.known().table->row.settings.game == rules::Game::Practice;
    if (wide_button(screen, is_practice ? "End the practice" : "Concede the match")) {
        screen.game.concede();
    }
}

void begin_changes(Screen& screen, const protocol::server::TableRow& row) {
    TableWishes& wishes = screen.menu.table;
    wishes.game = static_cast<int>(row.settings.game);
    wishes.race_to = row.settings.race_to;
    wishes.table_size = static_cast<int>(row.settings.table);
    wishes.delay_s = static_cast<int>(row.settings.spectator_delay_s);
    wishes.is_private = row.is_private;
    wishes.has_passcode = row.has_passcode;
    wishes.passcode.clear();
    open(screen, MenuPage::Table);
}

void draw_invites(Screen& screen) {
    const auto ask = [&](protocol::Role role) {
        screen.game.make_invite(role);
        screen.copies_invite = true;
    };
    if (half_button(screen, "Invite a player", false)) ask(protocol::Role::Player);
    if (half_button(screen, "Invite spectators", true)) ask(protocol::Role::Spectator);
    if (wide_button(screen, "Revoke all invites")) {
        screen.game.revoke_invites();
        screen.copied.clear();
    }
    if (screen.copied.empty()) return;
    quiet_line(screen, "On the clipboard now, to be sent to whoever shall come:");
    quiet_line(screen, screen.copied.c_str());
}

void send_changes(Screen& screen, const protocol::server::TableRow& row) {
    const TableWishes& wishes = screen.menu.table;
    protocol::client::ChangeTable change;
    change.settings = settings_of(wishes, row.settings);
    change.is_private = wishes.is_private;
    if (!wishes.is_private) {
        change.passcode = "";
    } else if (!wishes.passcode.empty()) {
        change.passcode = wishes.passcode;
    }
    screen.game.change_table(change);
}

/// Players stay until their match is over.
void draw_kicks(Screen& screen, const protocol::server::TableRow& row, bool is_playing) {
    for (const model::Seat seat : model::kSeats) {
        const std::string& name = row.seats[seat].name;
        const bool is_other = row.seats[seat].taken && name != screen.game.known().name;
        if (!is_other || is_playing) continue;
        // Apart from its text: names may have "##".
        ImGui::PushID(static_cast<int>(seat));
        if (wide_button(screen, "Send the other player away")) screen.game.kick(name);
        ImGui::PopID();
    }
    const bool is_entered = text_field(screen, "Send away", screen.menu.kicked,
                                       protocol::kMaxShownNameLength, "Name#1a2b, then Enter");
    if (!is_entered || screen.menu.kicked.empty()) return;
    screen.game.kick(screen.menu.kicked);
    screen.menu.kicked.clear();
}

void draw_owners_page(Screen& screen, const TableView& table) {
    draw_invites(screen);
    const bool is_playing = table.match && table.match->stage != match::Stage::Over;
    if (is_playing) {
        quiet_line(screen, "What is played can be changed between two matches.");
    } else {
        draw_wishes(screen);
        if (wide_button(screen, "Change the table")) send_changes(screen, table.row);
    }
    draw_kicks(screen, table.row, is_playing);
    draw_back(screen);
}

}  // namespace

void draw_table_page(Screen& screen) {
    const TableView& table = *screen.game.known().table;
    screen.menu.trouble.clear();
    say_refusal(screen);
    const bool is_owner = client::is_owner(screen.game.known(), table);
    if (is_owner && screen.menu.page == MenuPage::Table) return draw_owners_page(screen, table);
    const Offered offered = screen.game.offered(screen.now);
    if (wide_button(screen, "Back to the table")) screen.menu.is_open = false;
    draw_agreements(screen, offered);
    if (is_owner && wide_button(screen, "Your table")) begin_changes(screen, table.row);
    draw_way_out(screen, offered);
    if (half_button(screen, "Help", false)) open(screen, MenuPage::Help);
    if (half_button(screen, "Quit", true)) screen.wants_to_quit = true;
}

}  // namespace billiards::client
