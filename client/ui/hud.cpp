// Takes what is shown and what is aimed at; draws lines and rings over the table, and the words of
// its neighbours.
#include "client/ui/hud.h"

#include "client/play/aim_help.h"
#include "client/ui/hands.h"
#include "client/ui/hud_parts.h"
#include "common/model/table_spec.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace billiards::client {

namespace {

constexpr ImU32 kAimColor = IM_COL32(255, 255, 255, 170);
constexpr ImU32 kRed = IM_COL32(235, 70, 55, 235);
constexpr ImU32 kGold = IM_COL32(240, 190, 90, 235);
constexpr double kObjectLine_m = 0.35;

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

/// The first three things that a new player must know, until somebody has shot. What is said at
/// the table stands in the same place.
void draw_hints(const Screen& screen, const match::MatchState& match) {
    if (match.shots_played > 0 || !screen.game.acting()) return;
    if (screen.talk.is_open || !screen.game.known().chat.empty()) return;
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
    if (!screen.menu.is_open) {
        draw_asks(screen, *table);
        draw_talk(screen, *table);
        draw_rewatch(screen, *table);
    }
    if (!table->match || screen.game.presentation().rolling() != nullptr) return;
    if (screen.game.is_rewatching()) return;
    const OnTable on_table(screen, *ImGui::GetBackgroundDrawList());
    if (screen.game.acting() && table->match->stage == match::Stage::Shooting) {
        draw_aim(screen, *table->match, on_table);
        draw_call(screen, *table->match, on_table);
    }
    draw_held_ball(screen, on_table);
    if (screen.dragged) on_table.ring(screen.dragged->at_m, radius_m(), kGold, 2.5F);
    if (!screen.menu.is_open) draw_hints(screen, *table->match);
}

}  // namespace billiards::client
