// Takes a table; draws its players, score and clock at the upper edge, and sentences below.
#include "client/app/narrate.h"
#include "client/play/information.h"
#include "client/ui/hud_parts.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace billiards::client {

namespace {

std::string player_line(const TableView& table, model::Seat seat) {
    std::string line = table.row.seats[seat].taken ? short_name(table, seat) : "(free seat)";
    if (table.match && table.match->rack.groups) {
        line += " - " + words((*table.match->rack.groups)[seat]);
    }
    if (table.row.seats[seat].taken && !table.row.seats[seat].connected) line += " (away)";
    return line;
}

struct Piece {
    std::string text;
    ImVec4 color;
};

float width_of(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x;
}

void put(float left, const Piece& piece) {
    ImGui::SameLine(left);
    ImGui::TextColored(piece.color, "%s", piece.text.c_str());
}

/// The score in the middle, the players on both sides of it, the clock at the right.
void draw_players(const Screen& screen, const TableView& table, float least_width) {
    const bool is_playing = table.match && table.match->stage != match::Stage::Over;
    const auto player = [&](model::Seat seat) {
        const bool acts = is_playing && table.match->to_act == seat;
        return Piece{player_line(table, seat), acts ? colors::kAccent : colors::kText};
    };
    const Piece first = player(model::Seat::First);
    const Piece second = player(model::Seat::Second);
    const Piece score{score_of(table), colors::kText};
    const auto left_s = seconds_left(screen.game, screen.now);
    const Piece clock{left_s ? fmt::format("{} s", *left_s) : "",
                      left_s && is_low(*left_s) ? colors::kWarning : colors::kQuiet};

    const float gap = 18.0F * screen.scale;
    const float clock_width = left_s ? width_of("000 s") + gap : 0.0F;
    const float side = std::max(width_of(first.text), width_of(second.text)) + gap + clock_width;
    const float padding = ImGui::GetStyle().WindowPadding.x;
    const float half = std::max(side + width_of(score.text) / 2, least_width / 2);
    const float middle = padding + half;
    const float half_score = width_of(score.text) / 2;
    ImGui::Dummy({2 * half, 0.0F});
    put(middle - half_score - gap - width_of(first.text), first);
    put(middle - half_score, score);
    put(middle + half_score + gap, second);
    if (left_s) put(padding + 2 * half - width_of(clock.text), clock);
}

/// One player alone with the balls has neither a score nor an opponent.
void draw_title(const TableView& table, float least_width) {
    const std::string text = "Practice - " + table.row.seats[model::Seat::First].name;
    const float width = std::max(least_width, width_of(text));
    ImGui::Dummy({width, 0.0F});
    put(ImGui::GetStyle().WindowPadding.x + (width - width_of(text)) / 2, {text, colors::kText});
}

struct Below {
    std::string text;
    ImVec4 color;
};

std::vector<Below> lines_below(const Screen& screen) {
    std::vector<Below> lines;
    if (std::string next = what_follows(screen.game); !next.empty()) {
        lines.push_back({std::move(next), colors::kText});
    }
    for (std::string& note : notes(screen.game, screen.now)) {
        lines.push_back({std::move(note), colors::kAccent});
    }
    return lines;
}

void draw_centered(const Below& line) {
    ImGui::SetCursorPosX((ImGui::GetWindowWidth() - width_of(line.text)) / 2);
    ImGui::TextColored(line.color, "%s", line.text.c_str());
}

}  // namespace

void begin_strip(const Screen& screen, const char* name, float from_top, ImGuiWindowFlags flags) {
    const float middle = screen.table_width(ImGui::GetIO().DisplaySize.x) / 2;
    ImGui::SetNextWindowPos({middle, from_top}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.72F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8.0F * screen.scale);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav | flags);
    ImGui::PopStyleVar();
}

void draw_score(Screen& screen, const TableView& table) {
    const std::vector<Below> lines = lines_below(screen);
    float widest = 0.0F;
    for (const Below& line : lines) widest = std::max(widest, width_of(line.text));
    begin_strip(screen, "score", kStripMargin * screen.scale);
    ImGui::PushFont(screen.letters.large);
    if (table.row.settings.game == rules::Game::Practice) {
        draw_title(table, widest);
    } else {
        draw_players(screen, table, widest);
    }
    ImGui::PopFont();
    for (const Below& line : lines) draw_centered(line);
    screen.score_ends_at = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
    ImGui::End();
}

}  // namespace billiards::client
