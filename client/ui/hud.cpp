// Takes what is shown and what is aimed at; draws lines, rings and words over the table.
#include "client/ui/hud.h"

#include "client/app/narrate.h"
#include "client/play/aim_help.h"
#include "client/play/information.h"
#include "client/ui/hands.h"
#include "common/model/table_spec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <vector>

namespace billiards::client {

namespace {

constexpr ImU32 kAimColor = IM_COL32(255, 255, 255, 170);
constexpr ImU32 kRed = IM_COL32(235, 70, 55, 235);
constexpr ImU32 kGold = IM_COL32(240, 190, 90, 235);
constexpr double kObjectLine_m = 0.35;
constexpr int kLowTime_s = 10;
constexpr float kStripMargin = 10.0F;  ///< Between a strip and the window's edge.
constexpr float kChoicesFromTop = 92.0F;

double radius_m() {
    return model::BallSpec{}.radius_m;
}

/// Draws on the level of the balls' centres.
class OnTable {
  public:
    OnTable(const Screen& screen, ImDrawList& draw) : screen_(screen), draw_(draw) {}

    void line(base::Vec2 from_m, base::Vec2 to_m, ImU32 color, float width) const {
        const auto from = point(from_m);
        const auto to = point(to_m);
        if (from && to) draw_.AddLine(*from, *to, color, width);
    }
    void ring(base::Vec2 middle_m, double ring_m, ImU32 color, float width) const {
        constexpr int kSides = 40;
        const auto corner_m = [&](int side) {
            const double angle = 2 * std::numbers::pi * side / kSides;
            return middle_m + ring_m * base::Vec2(std::cos(angle), std::sin(angle));
        };
        for (int side = 0; side < kSides; ++side) {
            line(corner_m(side), corner_m(side + 1), color, width);
        }
    }

  private:
    std::optional<ImVec2> point(base::Vec2 at_m) const {
        const auto place =
            screen_.camera.place_of(base::Vec3(at_m, radius_m()), aspect_of(screen_));
        return place ? std::optional(point_of(screen_, *place)) : std::nullopt;
    }

    const Screen& screen_;
    ImDrawList& draw_;
};

void draw_aim(const Screen& screen, const match::MatchState& match, const OnTable& on_table) {
    const auto cue_ball_m = screen.game.cue_ball_m();
    if (!screen.shows_aim_line || !cue_ball_m) return;
    const auto help = aim_help(match, *cue_ball_m, screen.game.shot().shot());
    if (!help) return;
    for (std::size_t i = 1; i < help->cue_ball_way_m.size(); ++i) {
        on_table.line(help->cue_ball_way_m[i - 1], help->cue_ball_way_m[i], kAimColor, 1.6F);
    }
    if (!help->ghost_ball_m) return;
    on_table.ring(*help->ghost_ball_m, radius_m(), kAimColor, 1.6F);
    on_table.line(help->object_ball_m, help->object_ball_m + kObjectLine_m * help->object_ball_way,
                  kAimColor, 1.6F);
}

void draw_held_ball(const Screen& screen, const OnTable& on_table) {
    const auto& placing = screen.game.placing();
    if (!placing || !screen.game.acting()) return;
    const ImU32 color = placing->is_legal() ? kGold : kRed;
    on_table.ring(placing->position_m(), 1.35 * radius_m(), color, 2.5F);
}

void draw_call(const Screen& screen, const match::MatchState& match, const OnTable& on_table) {
    const auto* called = std::get_if<model::CalledBall>(&screen.game.shot().call());
    const auto ball = screen.called_ball ? screen.called_ball
                      : called           ? std::optional(called->ball)
                                         : std::nullopt;
    if (!ball) return;
    if (const model::PlacedBall* placed = match.layout.find(*ball)) {
        on_table.ring(placed->position_m, 1.35 * radius_m(), kGold, 2.5F);
    }
    const auto& pockets = model::table_of(match.settings.table).pockets;
    for (std::size_t i = 0; i < pockets.size(); ++i) {
        const bool is_called =
            !screen.called_ball && called != nullptr && called->pocket.number == i;
        if (is_called || screen.called_ball) {
            on_table.ring(pockets[i].center_m, pockets[i].radius_m, kGold, is_called ? 4.0F : 1.5F);
        }
    }
}

/// A strip of its own, in the middle of the table; words alone let the mouse through to the balls.
bool begin_strip(const Screen& screen, const char* name, float from_top,
                 ImGuiWindowFlags flags = ImGuiWindowFlags_NoInputs) {
    const float middle = screen.table_width(ImGui::GetIO().DisplaySize.x) / 2;
    ImGui::SetNextWindowPos({middle, from_top}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.72F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8.0F * screen.scale);
    const bool is_open =
        ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_NoNav | flags);
    ImGui::PopStyleVar();
    return is_open;
}

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
    const model::PerSeat<int>& racks = table.match ? table.match->racks_won : table.row.racks_won;
    const Piece score{fmt::format("{} : {}", racks[model::Seat::First], racks[model::Seat::Second]),
                      colors::kText};
    const auto left_s = seconds_left(screen.game, screen.now);
    const Piece clock{left_s ? fmt::format("{} s", *left_s) : "",
                      left_s && *left_s <= kLowTime_s ? colors::kWarning : colors::kQuiet};

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

/// Who plays, and below what follows.
void draw_score(Screen& screen, const TableView& table) {
    const std::string next = what_follows(screen.game);
    const float next_width = width_of(next);
    begin_strip(screen, "score", kStripMargin * screen.scale);
    ImGui::PushFont(screen.letters.large);
    draw_players(screen, table, next_width);
    ImGui::PopFont();
    if (!next.empty()) {
        ImGui::SetCursorPosX((ImGui::GetWindowWidth() - next_width) / 2);
        ImGui::TextUnformatted(next.c_str());
    }
    ImGui::End();
}

std::string as_title(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] += 'A' - 'a';
    return text;
}

void draw_big_buttons(Screen& screen, const TableView& table) {
    const bool is_over = !table.match || table.match->stage == match::Stage::Over;
    const bool chooses =
        screen.game.acting() && table.match && table.match->stage == match::Stage::Choosing;
    if (!chooses && (!is_over || table.my_seats.empty())) return;
    begin_strip(screen, "choices", kChoicesFromTop * screen.scale, ImGuiWindowFlags_None);
    const ImVec2 size{340.0F * screen.scale, 40.0F * screen.scale};
    ImGui::PushFont(screen.letters.large);
    if (table.over && !screen.game.presentation().lines().empty()) {
        ImGui::TextColored(colors::kAccent, "%s",
                           screen.game.presentation().lines().back().c_str());
    }
    if (is_over) {
        ImGui::BeginDisabled(screen.game.has_asked_to_start());
        if (ImGui::Button("Start", size)) screen.game.ready();
        ImGui::EndDisabled();
        screen.controls.note("Start");
    }
    if (chooses && table.match->pending) {
        for (const rules::Choice choice : table.match->pending->verdict.choices) {
            const std::string text = words(choice);
            if (ImGui::Button(as_title(text).c_str(), size)) screen.game.choose(choice);
            screen.controls.note("Choose " + text);
        }
    }
    ImGui::PopFont();
    ImGui::End();
}

/// The first three things that a new player must know, until somebody has shot.
void draw_hints(const Screen& screen, const match::MatchState& match) {
    if (match.shots_played > 0 || !screen.game.acting()) return;
    constexpr std::array kHints{
        "Aim: move the mouse over the table.",
        "Shoot: press the left button, pull back, let go. Or wheel for power, and Space.",
        "Spin: hold E and move the mouse, or click the white ball at the right."};
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float height = line * kHints.size() + 2 * ImGui::GetStyle().WindowPadding.y;
    begin_strip(screen, "hints", display.y - height - kStripMargin * screen.scale);
    for (const char* hint : kHints) ImGui::TextUnformatted(hint);
    ImGui::End();
}

}  // namespace

void draw_hud(Screen& screen) {
    const TableView* table = screen.game.presentation().table();
    if (table == nullptr) return;
    draw_score(screen, *table);
    if (!screen.menu.is_open) draw_big_buttons(screen, *table);
    if (!table->match || screen.game.presentation().rolling() != nullptr) return;
    const OnTable on_table(screen, *ImGui::GetBackgroundDrawList());
    if (screen.game.acting() && table->match->stage == match::Stage::Shooting) {
        draw_aim(screen, *table->match, on_table);
        draw_call(screen, *table->match, on_table);
    }
    draw_held_ball(screen, on_table);
    if (!screen.menu.is_open) draw_hints(screen, *table->match);
}

}  // namespace billiards::client
