// Takes what may be asked for now; draws it as buttons below the score, and asks.
#include "client/app/narrate.h"
#include "client/play/offered.h"
#include "client/ui/hud_parts.h"
#include "client/ui/ways.h"

#include <algorithm>
#include <fmt/format.h>

namespace billiards::client {

namespace {

constexpr float kButtonWidth = 340.0F;
constexpr float kButtonHeight = 40.0F;
constexpr float kFromTop = 122.0F;

bool big_button(Screen& screen, const std::string& text, const std::string& name) {
    const ImVec2 size{kButtonWidth * screen.scale, kButtonHeight * screen.scale};
    const bool is_clicked = ImGui::Button(text.c_str(), size);
    screen.controls.note(name);
    return is_clicked;
}

bool big_button(Screen& screen, const std::string& text) {
    return big_button(screen, text, text);
}

bool small_button(Screen& screen, const std::string& text, const std::string& name) {
    const bool is_clicked = ImGui::Button(text.c_str());
    screen.controls.note(name);
    return is_clicked;
}

std::string as_title(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] += 'A' - 'a';
    return text;
}

bool is_waiting_for_second(const TableView& table) {
    const auto& seats = table.row.seats;
    return !seats[model::Seat::First].taken || !seats[model::Seat::Second].taken;
}

/// Where the other player comes to, and the way to tell them.
void draw_invitation(Screen& screen, const TableView& table) {
    const std::string place =
        fmt::format("Table {} at {}", table.row.table.value, to_text(address_for_others(screen)));
    ImGui::PushFont(screen.letters.normal);
    ImGui::TextUnformatted(place.c_str());
    ImGui::PopFont();
    if (!client::is_owner(screen.game.known(), table)) return;
    const bool is_copied = !screen.copied.empty();
    if (big_button(screen, is_copied ? "Copied: send it to a friend" : "Copy an invite",
                   "Copy an invite")) {
        screen.game.make_invite(protocol::Role::Player);
        screen.copies_invite = true;
    }
}

void draw_between_matches(Screen& screen, const TableView& table, const Offered& offered) {
    const auto& lines = screen.game.presentation().lines();
    if (table.over && !lines.empty()) {
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + kButtonWidth * screen.scale);
        ImGui::TextColored(colors::kAccent, "%s", as_title(lines.back()).c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::BeginDisabled(screen.game.has_asked_to_start());
    if (offered.start && big_button(screen, "Start")) screen.game.ready();
    if (offered.rematch && big_button(screen, "Rematch")) screen.game.rematch();
    ImGui::EndDisabled();
    // Last, so that nothing moves away from the mouse when the other player comes.
    if (is_waiting_for_second(table)) draw_invitation(screen, table);
    if (table.over && big_button(screen, "Leave")) leave_table(screen);
}

void draw_choices(Screen& screen, const match::MatchState& match) {
    for (const rules::Choice choice : match.pending->verdict.choices) {
        const std::string text = words(choice);
        if (big_button(screen, as_title(text), "Choose " + text)) screen.game.choose(choice);
    }
}

void draw_answers(Screen& screen) {
    if (big_button(screen, "Accept")) screen.game.answer_offer(true);
    if (big_button(screen, "Decline")) screen.game.answer_offer(false);
}

/// What helps a player, and need not be clicked.
void draw_small(Screen& screen, const TableView& table, const Offered& offered) {
    if (offered.extension) {
        const std::string text =
            fmt::format("Extension: {:.0f} s more", table.row.settings.extension_s);
        if (small_button(screen, text, "Extension")) screen.game.extend();
    }
    if (offered.spot_nearest &&
        small_button(screen, "Spot the nearest ball", "Spot the nearest ball")) {
        screen.game.spot_nearest();
    }
    if (!offered.practise) return;
    if (small_button(screen, "Undo", "Undo")) screen.game.undo();
    ImGui::SameLine();
    ImGui::BeginDisabled(!offered.repeat);
    if (small_button(screen, "Repeat the shot", "Repeat")) screen.game.repeat();
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (small_button(screen, "Re-rack", "Re-rack")) screen.game.rerack();
}

}  // namespace

void draw_asks(Screen& screen, const TableView& table) {
    const Offered offered = screen.game.offered(screen.now);
    const bool is_between = offered.start || offered.rematch;
    const bool chooses = screen.game.acting() && table.match && table.match->pending &&
                         table.match->stage == match::Stage::Choosing;
    const bool has_small = offered.extension || offered.spot_nearest || offered.practise;
    if (!is_between && !chooses && !offered.answer && !offered.claim_match && !has_small) return;
    // Below one note at least, so that nothing moves away from the mouse when one comes.
    const float from_top = std::max(kFromTop, screen.score_ends_at / screen.scale + kStripMargin);
    begin_strip(screen, "choices", from_top * screen.scale, ImGuiWindowFlags_None);
    ImGui::PushFont(screen.letters.large);
    if (is_between) draw_between_matches(screen, table, offered);
    if (chooses) draw_choices(screen, *table.match);
    if (offered.answer) draw_answers(screen);
    if (offered.claim_match && big_button(screen, "Claim the match")) screen.game.claim_match();
    ImGui::PopFont();
    draw_small(screen, table, offered);
    ImGui::End();
}

}  // namespace billiards::client
