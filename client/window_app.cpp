// Takes SDL's events and the clock; draws one frame after another.
#include "client/window_app.h"

#include "client/net/clock.h"
#include "client/render/picture.h"
#include "client/scene/falling.h"
#include "client/ui/hud.h"
#include "client/ui/menu.h"
#include "client/ui/panel.h"
#include "client/ui/report.h"
#include "client/ui/ways.h"

#include <backends/imgui_impl_opengl3.h>
#include <backends/imgui_impl_sdl.h>
#include <ctime>
#include <fmt/format.h>
#include <imgui.h>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace billiards::client {

namespace {

/// How far the tip is from the ball at least, and how much of the pull is shown, so that the butt
/// stays in the picture.
constexpr double kRestingTip_m = 0.02;
constexpr double kDrawnBack = 0.35;
/// From here on a coarse ball looks like a fine one.
constexpr double kFarBalls_m = 1.2;

model::TableSize table_size(const Screen& screen) {
    const TableView* table = screen.game.presentation().table();
    return table != nullptr ? table->row.settings.table
                            : static_cast<model::TableSize>(screen.menu.table.table_size);
}

template <class T>
std::size_t hash_of(const ImVector<T>& values, std::size_t before) {
    const std::string_view bytes(reinterpret_cast<const char*>(values.Data),
                                 static_cast<std::size_t>(values.size_in_bytes()));
    return 31 * before + std::hash<std::string_view>()(bytes);
}

std::size_t hash_of(const ImDrawData& interface) {
    std::size_t hash = 0;
    for (int i = 0; i < interface.CmdListsCount; ++i) {
        hash = hash_of(interface.CmdLists[i]->VtxBuffer, hash);
        hash = hash_of(interface.CmdLists[i]->IdxBuffer, hash);
    }
    return hash;
}

/// Pictures are worth their time, which is not so in a window without a graphics card.
Quality quality_for(const WindowAppOptions& options) {
    const bool is_picture = options.window.is_offscreen && options.frames == 0;
    return is_picture ? Quality::Fine : quality_of_driver();
}

}  // namespace

WindowApp::Gui::Gui(const Window& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplSDL2_InitForOpenGL(window.sdl(), window.context());
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

WindowApp::Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
}

WindowApp::WindowApp(const WindowAppOptions& options)
    : options_(options),
      window_(options.window),
      gui_(window_),
      quality_(quality_for(options)),
      renderer_(options.assets, quality_),
      screen_(options.seed, options.data) {
    screen_.menu.name = options.name;
    if (!options.report.empty()) {
        report_.open(options.report);
        if (!report_) {
            throw std::runtime_error(
                fmt::format("The report {} cannot be written.", options.report.string()));
        }
    }
    if (options.server) {
        screen_.session = {.where = Whereabouts::Elsewhere,
                           .address = to_text(*options.server),
                           .name = options.name};
        screen_.game.connect(*options.server, options.name, options.errand);
        screen_.menu.page = MenuPage::Tables;
        screen_.menu.address = to_text(*options.server);
        screen_.menu.watches = options.watches;
        screen_.menu.is_open = std::holds_alternative<LookAround>(options.errand);
    }
}

WindowApp::~WindowApp() = default;

void WindowApp::run() {
    options_.pictures.empty() ? run_window() : draw_pictures();
}

void WindowApp::run_window() {
    while (!screen_.wants_to_quit) {
        take_events();
        screen_.now = local_now();
        screen_.game.advance(screen_.now);
        follow_up(screen_);
        const Frame frame = lay_out();
        write_report();
        if (options_.scene) {
            if (stage_scene(frame)) return;
        } else if (shown_ != frame) {
            draw(frame);
            window_.present();
            shown_ = frame;
        }
        rest(screen_.now);
    }
}

void WindowApp::rest(base::Instant frame_began) const {
    constexpr double kShare = 0.9;  // Of a picture's time: the last of it is the screen's to wait.
    const double left_s =
        kShare / window_.refresh_rate() - base::seconds(local_now() - frame_began);
    if (left_s > 0) SDL_Delay(static_cast<Uint32>(1000 * left_s));
}

void WindowApp::take_events() {
    SDL_Event event;
    screen_.repeated.clear();
    input_.start_frame();
    SDL_PumpEvents();
    while (SDL_PeepEvents(&event, 1, SDL_PEEKEVENT, SDL_FIRSTEVENT, SDL_LASTEVENT) > 0) {
        if (!input_.take(event)) return;
        SDL_PeepEvents(&event, 1, SDL_GETEVENT, SDL_FIRSTEVENT, SDL_LASTEVENT);
        ImGui_ImplSDL2_ProcessEvent(&event);
        if (event.type == SDL_KEYDOWN || event.type == SDL_KEYUP) take_key(event.key);
        if (event.type == SDL_WINDOWEVENT) shown_.reset();
        if (event.type == SDL_QUIT) screen_.wants_to_quit = true;
    }
}

void WindowApp::take_key(const SDL_KeyboardEvent& key) {
    // As it was when the key was pressed; the backend asks how it is now.
    ImGui::GetIO().KeyShift = (key.keysym.mod & KMOD_SHIFT) != 0;
    ImGui::GetIO().KeyCtrl = (key.keysym.mod & KMOD_CTRL) != 0;
    if (key.type != SDL_KEYDOWN) return;
    if (key.repeat != 0) {
        screen_.repeated.push_back(key.keysym.scancode);
        return;
    }
    if (key.keysym.scancode == SDL_SCANCODE_F11) {
        window_.toggle_full_screen();
    } else if (key.keysym.scancode == SDL_SCANCODE_F1) {
        screen_.menu.is_open = true;
        screen_.menu.page = MenuPage::Help;
    }
}

WindowApp::Frame WindowApp::lay_out() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    input_.place_mouse(ImGui::GetIO());
    fit_look();
    ImGui::NewFrame();
    screen_.controls.start_frame();
    const bool menu_was_open = screen_.menu.is_open;
    draw_panel(screen_);
    draw_hud(screen_);
    draw_menu(screen_);
    if (!menu_was_open) hands_.handle(screen_);
    ImGui::Render();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const Window::Size size = window_.drawable_size();
    const float scale = static_cast<float>(size.width) / display.x;
    const int width = static_cast<int>(screen_.table_width(display.x) * scale);
    std::vector<Drawn> drawn = scene();
    return {.scene = std::move(drawn),
            .camera = screen_.camera,
            .viewport = {.width = width, .height = size.height},
            .interface = hash_of(*ImGui::GetDrawData())};
}

void WindowApp::draw(const Frame& frame) {
    renderer_.draw(frame.scene, frame.camera, frame.viewport);
    const Window::Size size = window_.drawable_size();
    glViewport(0, 0, size.width, size.height);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void WindowApp::fit_look() {
    const float scale = interface_scale(ImGui::GetIO().DisplaySize.y);
    if (scale == screen_.scale) return;
    screen_.scale = scale;
    screen_.letters = set_look(scale);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

std::vector<Drawn> WindowApp::scene() {
    const model::TableSize size = table_size(screen_);
    std::vector<ShownBall> balls = screen_.game.balls(screen_.now);
    look_at(balls);
    if (const Playback* rolling = screen_.game.presentation().rolling()) {
        const timeline::Timeline& timeline = rolling->shot().record.timeline;
        if (shown_shot_ != rolling->shot().sequence) orientations_.start_shot();
        shown_shot_ = rolling->shot().sequence;
        const double time_s =
            rolling->shot().record.duration_s - base::seconds(rolling->ends_at() - screen_.now);
        orientations_.advance(timeline, time_s);
        const auto falling = falling_balls(timeline, model::table_of(size), time_s);
        balls.insert(balls.end(), falling.begin(), falling.end());
    }
    std::optional<HeldCue> cue;
    const auto cue_ball_m = screen_.game.cue_ball_m();
    if (cue_ball_m && screen_.game.acting()) {
        const ShotControl& shot = screen_.game.shot();
        cue = HeldCue{.ball_m = *cue_ball_m,
                      .shot = shot.shot(),
                      .drawn_back_m = kRestingTip_m + kDrawnBack * shot.drawn_back_m()};
    }
    const bool is_far = screen_.camera.distance_m() > kFarBalls_m;
    const Detail detail = quality_ == Quality::Quick && is_far ? Detail::Coarse : Detail::Fine;
    return scene_of(size, balls, orientations_, cue, detail);
}

/// The eye turns about the ball that it follows, while that is in play.
void WindowApp::look_at(const std::vector<ShownBall>& balls) {
    std::optional<base::Vec3> target_m;
    for (const ShownBall& ball : balls) {
        const bool is_followed = screen_.follows_ball && ball.ball == screen_.followed;
        if (is_followed) target_m = ball.state.position_m;
    }
    screen_.camera.follow(target_m);
}

void WindowApp::write_report() {
    if (!report_.is_open()) return;
    std::string report = report_of(screen_);
    if (report == last_report_) return;
    report_ << report << std::endl;
    last_report_ = std::move(report);
}

bool WindowApp::stage_scene(const Frame& frame) {
    const bool is_there = (*options_.scene)(screen_);
    for (const std::string& trouble : {screen_.menu.trouble, screen_.game.lost()}) {
        if (!trouble.empty()) throw std::runtime_error(trouble);
    }
    if (!is_there || ++frames_at_scene_ < kFramesUntilSettled) return false;
    draw(frame);
    if (options_.frames > 0) {
        measure_frames();
    } else {
        save_picture(window_, options_.screenshot);
    }
    return true;
}

/// From looking at the game until the pixels are there, as if every frame were a new one.
void WindowApp::measure_frames() {
    glFinish();
    const base::Instant began = local_now();
    const std::clock_t worked = std::clock();
    for (int i = 0; i < options_.frames; ++i) {
        screen_.now = local_now();
        screen_.game.advance(screen_.now);
        draw(lay_out());
        window_.present();
    }
    glFinish();
    const double each_ms = 1000 * base::seconds(local_now() - began) / options_.frames;
    const double work_ms = 1000.0 * static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC;
    const Window::Size size = window_.drawable_size();
    fmt::print("{} frames of {}x{}: {:.1f} ms each, and {:.1f} ms of processor time\n",
               options_.frames, size.width, size.height, each_ms, work_ms / options_.frames);
}

}  // namespace billiards::client
