// Takes ImGui's mouse and keys; gives what they mean over the table.
#include "client/ui/hands.h"

#include "common/model/table_spec.h"

#include <SDL.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace billiards::client {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kFineTurn_rad = 0.03 * kDegree;
constexpr double kCoarseTurn_rad = 0.23 * kDegree;
constexpr double kOrbitPerUnit_rad = 0.35 * kDegree;
constexpr double kTipPerUnit = 0.005;
constexpr double kElevationPerUnit_rad = 0.3 * kDegree;
constexpr double kCtrlAims = 0.1;  ///< Of the way that the mouse went.
/// Pulled back by this many window units, the cue has all its power.
constexpr double kFullPullUnits = 320.0;
/// Less than this is a click, not a pull.
constexpr float kClickUnits = 5.0F;
constexpr double kLeastDrag_m = 0.01;
constexpr base::Duration kTwiceWithin = std::chrono::seconds(1);

double radius_m() {
    return model::BallSpec{}.radius_m;
}

const model::TableSpec* table_of(const Screen& screen) {
    const TableView* table = screen.game.presentation().table();
    if (table == nullptr) return nullptr;
    const auto& settings = table->match ? table->match->settings : table->row.settings;
    return &model::table_of(settings.table);
}

/// Where the mouse points on the level of the balls' centres.
std::optional<base::Vec2> under_mouse(const Screen& screen) {
    return screen.camera.point_at(place_of(screen, ImGui::GetIO().MousePos), aspect_of(screen),
                                  radius_m());
}

bool is_key_down(SDL_Scancode key) {
    return ImGui::IsKeyDown(key);
}

/// Since the last frame: pressed, or said again by the system, which knows how long it was held;
/// ImGui would take one slow frame for a long press.
int strokes(const Screen& screen, SDL_Scancode key) {
    const auto again = std::ranges::count(screen.repeated, key);
    return static_cast<int>(again) + (ImGui::IsKeyPressed(key, false) ? 1 : 0);
}

/// Which of the table's four directions lies ahead of the eye.
base::Vec2 ahead(const Camera& camera) {
    const base::Vec2 way = base::Vec2(camera.target_m() - camera.eye_m());
    if (std::fabs(way.x) > std::fabs(way.y)) return {way.x > 0 ? 1.0 : -1.0, 0.0};
    return {0.0, way.y > 0 ? 1.0 : -1.0};
}

std::optional<model::BallId> ball_at(const Screen& screen, base::Vec2 at_m) {
    for (const ShownBall& ball : screen.game.balls(screen.now)) {
        if (glm::distance(base::Vec2(ball.state.position_m), at_m) <= radius_m()) return ball.ball;
    }
    return std::nullopt;
}

/// Sets down what is in hand; otherwise there is something to say.
void press_return(Screen& screen) {
    const auto& placing = screen.game.placing();
    if (screen.game.acting() && placing && !placing->is_down()) {
        screen.game.set_down();
    } else {
        screen.talk.is_open = screen.talk.takes_focus = true;
    }
}

}  // namespace

double aspect_of(const Screen& screen) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    return static_cast<double>(screen.table_width(display.x)) / static_cast<double>(display.y);
}

base::Vec2 place_of(const Screen& screen, const ImVec2& point) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    return {2.0 * point.x / screen.table_width(display.x) - 1.0, 1.0 - 2.0 * point.y / display.y};
}

ImVec2 point_of(const Screen& screen, base::Vec2 place) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    return {static_cast<float>((place.x + 1.0) / 2.0) * screen.table_width(display.x),
            static_cast<float>((1.0 - place.y) / 2.0) * display.y};
}

void Hands::handle(Screen& screen) {
    if (screen.menu.is_open) return;
    if (!ImGui::GetIO().WantTextInput) handle_keys(screen);
    handle_mouse(screen);
}

void Hands::handle_mouse(Screen& screen) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto on_bed_m = under_mouse(screen);
    const bool is_over_table = !io.WantCaptureMouse;
    // A frame may see the mouse come and press; it has come with nothing held.
    const bool moved = io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F;
    if (moved && (is_over_table || hold_ != Hold::Nothing)) drag(screen, on_bed_m);
    if (hold_ == Hold::Nothing && is_over_table) {
        handle_wheel(screen);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) hold_ = Hold::Eye;
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && on_bed_m) press(screen, *on_bed_m);
    }
    release(screen);
}

void Hands::press(Screen& screen, base::Vec2 on_bed_m) {
    pressed_at_ = ImGui::GetIO().MousePos;
    pressed_on_bed_m_ = on_bed_m;
    if (!screen.game.acting()) return;
    const auto cue_ball_m = screen.game.cue_ball_m();
    const bool on_cue_ball = cue_ball_m && glm::distance(*cue_ball_m, on_bed_m) < 1.5 * radius_m();
    const auto ball =
        screen.game.offered(screen.now).practise ? ball_at(screen, on_bed_m) : std::nullopt;
    if (screen.game.placing() && on_cue_ball) {
        hold_ = Hold::CueBall;
    } else if (ball) {
        hold_ = Hold::Ball;
        screen.dragged = {.ball = *ball, .at_m = on_bed_m};
    } else if (cue_ball_m) {
        hold_ = Hold::Cue;
        screen.game.shot().begin_pull();
    }
}

void Hands::drag(Screen& screen, const std::optional<base::Vec2>& on_bed_m) {
    const ImGuiIO& io = ImGui::GetIO();
    ShotControl& shot = screen.game.shot();
    if (hold_ == Hold::Eye) {
        screen.camera.orbit(-io.MouseDelta.x * kOrbitPerUnit_rad,
                            io.MouseDelta.y * kOrbitPerUnit_rad);
    } else if (hold_ == Hold::CueBall) {
        if (on_bed_m) screen.game.hold_cue_ball_at(*on_bed_m);
    } else if (hold_ == Hold::Ball) {
        if (on_bed_m && screen.dragged) screen.dragged->at_m = *on_bed_m;
    } else if (hold_ == Hold::Cue) {
        const double units =
            std::hypot(io.MousePos.x - pressed_at_.x, io.MousePos.y - pressed_at_.y);
        shot.pull_to(units < kClickUnits ? 0.0 : units / kFullPullUnits);
    } else if (is_key_down(SDL_SCANCODE_E)) {
        spin_key_at_.reset();
        shot.move_tip({-io.MouseDelta.x * kTipPerUnit, -io.MouseDelta.y * kTipPerUnit});
    } else if (is_key_down(SDL_SCANCODE_B)) {
        shot.set_elevation(shot.shot().elevation_rad - io.MouseDelta.y * kElevationPerUnit_rad);
    } else if (const auto cue_ball_m = screen.game.cue_ball_m(); cue_ball_m && on_bed_m) {
        const double before_rad = shot.shot().angle_rad;
        shot.aim_at(*cue_ball_m, *on_bed_m);
        if (!io.KeyCtrl) return;
        const double way_rad =
            std::remainder(shot.shot().angle_rad - before_rad, 2 * std::numbers::pi);
        shot.set_angle(before_rad + kCtrlAims * way_rad);
    }
}

void Hands::release(Screen& screen) {
    if (hold_ == Hold::Eye && !ImGui::IsMouseDown(ImGuiMouseButton_Right)) hold_ = Hold::Nothing;
    if (hold_ == Hold::Cue && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        screen.game.shot().cancel_pull();
        hold_ = Hold::Nothing;
    }
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const Hold held = std::exchange(hold_, hold_ == Hold::Eye ? Hold::Eye : Hold::Nothing);
    if (held == Hold::CueBall) screen.game.set_down();
    if (held == Hold::Ball) drop_ball(screen);
    if (held != Hold::Cue) return;
    if (screen.game.shot().release()) {
        screen.game.shoot();
    } else {
        click(screen);
    }
}

/// A click alone moves nothing.
void Hands::drop_ball(Screen& screen) const {
    const auto dragged = std::exchange(screen.dragged, std::nullopt);
    if (!dragged || glm::distance(dragged->at_m, pressed_on_bed_m_) < kLeastDrag_m) return;
    screen.game.place_ball(dragged->ball, dragged->at_m);
}

/// Calls: first a ball, then its pocket.
void Hands::click(Screen& screen) {
    const model::TableSpec* table = table_of(screen);
    if (table == nullptr) return;
    const auto ball = ball_at(screen, pressed_on_bed_m_);
    if (ball && *ball != model::kCueBall) {
        screen.called_ball = ball;
        return;
    }
    if (!screen.called_ball) return;
    for (std::size_t i = 0; i < table->pockets.size(); ++i) {
        const model::PocketCircle& pocket = table->pockets[i];
        if (glm::distance(pocket.center_m, pressed_on_bed_m_) > 1.6 * pocket.radius_m) continue;
        const model::PocketId id{static_cast<std::uint8_t>(i)};
        screen.game.shot().set_call(model::CalledBall{*screen.called_ball, id});
        screen.called_ball.reset();
        return;
    }
}

void Hands::handle_wheel(Screen& screen) const {
    const ImGuiIO& io = ImGui::GetIO();
    // With Shift some systems turn the wheel sideways.
    const float steps = io.MouseWheel != 0.0F ? io.MouseWheel : io.MouseWheelH;
    if (steps == 0.0F) return;
    if (io.KeyShift) {
        screen.camera.zoom(steps);
    } else {
        screen.game.shot().step_power(static_cast<int>(std::lround(steps)));
    }
}

/// Twice in a row, with the mouse still: back to the centre.
void Hands::press_spin_key(Screen& screen) {
    const bool is_second = spin_key_at_ && screen.now - *spin_key_at_ < kTwiceWithin;
    if (is_second) screen.game.shot().set_tip({});
    spin_key_at_ = screen.now;
}

void Hands::handle_keys(Screen& screen) {
    const auto pressed = [](SDL_Scancode key) { return ImGui::IsKeyPressed(key, false); };
    handle_arrows(screen);
    if (pressed(SDL_SCANCODE_RETURN)) press_return(screen);
    if (pressed(SDL_SCANCODE_U)) screen.game.undo();
    if (pressed(SDL_SCANCODE_SPACE) && !ImGui::IsAnyItemActive()) screen.game.shoot();
    if (pressed(SDL_SCANCODE_E)) press_spin_key(screen);
    if (pressed(SDL_SCANCODE_Z)) screen.game.skip_roll();
    if (pressed(SDL_SCANCODE_O)) screen.camera.look_from_above();
    if (pressed(SDL_SCANCODE_V)) screen.camera.next_view();
    if (pressed(SDL_SCANCODE_T)) screen.shows_aim_line = !screen.shows_aim_line;
    if (pressed(SDL_SCANCODE_C)) {
        screen.called_ball.reset();
        screen.game.shot().set_call(model::NoCall{});
    }
    if (pressed(SDL_SCANCODE_ESCAPE) && hold_ == Hold::Cue) {
        screen.game.shot().cancel_pull();
        hold_ = Hold::Nothing;
    } else if (pressed(SDL_SCANCODE_ESCAPE)) {
        screen.menu.is_open = true;
        screen.menu.page = MenuPage::Main;
    }
}

/// The cue ball while it is in hand and not set down; else aim and power.
void Hands::handle_arrows(Screen& screen) const {
    const int right = strokes(screen, SDL_SCANCODE_RIGHT) - strokes(screen, SDL_SCANCODE_LEFT);
    const int up = strokes(screen, SDL_SCANCODE_UP) - strokes(screen, SDL_SCANCODE_DOWN);
    if (right == 0 && up == 0) return;
    const bool is_big = ImGui::GetIO().KeyShift;
    if (screen.game.placing() && !screen.game.placing()->is_down()) {
        const base::Vec2 away = ahead(screen.camera);
        const base::Vec2 sideways{away.y, -away.x};
        screen.game.move_cue_ball((is_big ? kBigNudge_m : kNudge_m) *
                                  (1.0 * up * away + 1.0 * right * sideways));
        return;
    }
    screen.game.shot().turn(-right * (is_big ? kCoarseTurn_rad : kFineTurn_rad));
    screen.game.shot().step_power(up);
}

}  // namespace billiards::client
