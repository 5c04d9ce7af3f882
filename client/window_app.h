// Takes options; runs the window: events in, frames out.
#pragma once

#include "client/play/rack_pictures.h"
#include "client/render/renderer.h"
#include "client/render/window.h"
#include "client/scene/orientation.h"
#include "client/ui/frame_input.h"
#include "client/ui/hands.h"
#include "client/ui/screen.h"
#include "client/ui/stage_scene.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace billiards::client {

struct WindowAppOptions {
    WindowOptions window;
    std::filesystem::path assets;
    std::filesystem::path data;  ///< Where this profile keeps what it plays.
    std::string name = "Player";
    std::uint64_t seed = 0;
    std::optional<SceneStep> scene;    ///< Ends the program once its picture is saved.
    std::filesystem::path screenshot;  ///< Of the scene.
    int frames = 0;                    ///< Above 0: not a picture, but so many timed ones.
    std::filesystem::path pictures;    ///< Folder for a watched match's; empty: none.
    std::filesystem::path report;      ///< Empty: none.
    Errand errand;                     ///< What to do at `server` at once.
    std::optional<ServerAddress> server;
    bool watches = false;  ///< A table that is chosen there is watched, not played at.
};

class WindowApp {
  public:
    /// Throws what the window, the models or the report cannot do, as a sentence.
    explicit WindowApp(const WindowAppOptions& options);
    ~WindowApp();
    WindowApp(const WindowApp&) = delete;
    WindowApp& operator=(const WindowApp&) = delete;

    /// Until somebody quits, or what is to be drawn is drawn.
    void run();

  private:
    /// All that makes a frame what it is: where nothing of it changes, none is drawn.
    struct Frame {
        std::vector<Drawn> scene;
        Camera camera;
        Viewport viewport;
        std::size_t interface = 0;  ///< A hash of what ImGui is going to draw.

        friend bool operator==(const Frame&, const Frame&) = default;
    };

    /// ImGui's context and its two backends.
    struct Gui {
        explicit Gui(const Window& window);
        ~Gui();
        Gui(const Gui&) = delete;
        Gui& operator=(const Gui&) = delete;
    };

    void run_window();
    void draw_pictures();
    void draw_picture(const DuePicture& picture);
    /// As many as one frame takes.
    void take_events();
    void take_key(const SDL_KeyboardEvent& key);
    /// The interface as it is now, and the scene: nothing is drawn yet.
    Frame lay_out();
    void draw(const Frame& frame);
    void measure_frames();
    /// Not faster than the screen, also where nothing waits for it.
    void rest(base::Instant frame_began) const;
    /// Letters and lengths follow the window's height.
    void fit_look();
    std::vector<Drawn> scene();
    void look_at(const std::vector<ShownBall>& balls);
    void write_report();
    /// Steps towards the scene; once it is there, draws it, and the program is done.
    bool stage_scene(const Frame& frame);

    WindowAppOptions options_;
    Window window_;
    Gui gui_;
    Quality quality_;
    Renderer renderer_;
    Screen screen_;
    FrameInput input_;
    Hands hands_;
    Orientations orientations_;
    std::uint64_t shown_shot_ = 0;  ///< The sequence of the shot that the orientations follow.
    std::ofstream report_;
    std::string last_report_;
    std::optional<Frame> shown_;  ///< None: the window's pixels may be gone.
    /// What ImGui measures in a frame, the next one is laid out by.
    static constexpr int kFramesUntilSettled = 4;
    int frames_at_scene_ = 0;
};

}  // namespace billiards::client
