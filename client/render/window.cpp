// Takes SDL; gives a window with OpenGL 3.3 core, or the sentence that says why not.
#include "client/render/window.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <string>

namespace billiards::client {

namespace {

constexpr int kMinWidth = 960;
constexpr int kMinHeight = 600;

[[noreturn]] void cannot(const std::string& what, const char* way_out) {
    throw CannotDraw(fmt::format("{}: {}. {}", what, SDL_GetError(), way_out));
}

void ask_for_opengl() {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS, SDL_GL_CONTEXT_FORWARD_COMPATIBLE_FLAG);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
}

}  // namespace

Window::Library::Library(bool is_offscreen) {
    SDL_SetMainReady();
    if (is_offscreen) SDL_SetHint(SDL_HINT_VIDEODRIVER, "offscreen");
    const bool is_there = SDL_Init(SDL_INIT_VIDEO | SDL_INIT_EVENTS) == 0;
    // With no display SDL would draw, unasked, what nobody sees.
    const std::string driver = is_there ? SDL_GetCurrentVideoDriver() : "";
    const bool is_seen = is_offscreen || (driver != "offscreen" && driver != "dummy");
    if (!is_there || !is_seen) {
        if (!is_seen) SDL_SetError("there is no display");
        cannot("No display can be opened",
               "With no display, --offscreen draws into pictures, and billiards-demo plays a match "
               "as text.");
    }
}

Window::Library::~Library() {
    SDL_Quit();
}

Window::Window(const WindowOptions& options) : library_(options.is_offscreen) {
    ask_for_opengl();
    const Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    window_.reset(SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED,
                                   SDL_WINDOWPOS_CENTERED, options.width, options.height, flags));
    if (!window_) {
        cannot("No window with OpenGL can be opened",
               "Is a graphics driver installed (Debian: "
               "libgl1-mesa-dri, libegl1)?");
    }
    // A picture is as large as it was asked for: without a display SDL would widen the window
    // alone.
    if (!options.is_offscreen) SDL_SetWindowMinimumSize(window_.get(), kMinWidth, kMinHeight);
    context_.reset(SDL_GL_CreateContext(window_.get()));
    if (!context_) {
        cannot("OpenGL 3.3 is not there",
               "A newer graphics driver has it, and so has Mesa's software renderer: try "
               "LIBGL_ALWAYS_SOFTWARE=1.");
    }
    if (epoxy_gl_version() < 33) {
        throw CannotDraw(
            fmt::format("OpenGL 3.3 is needed, and here is {}. Mesa's software "
                        "renderer has it: try LIBGL_ALWAYS_SOFTWARE=1.",
                        reinterpret_cast<const char*>(glGetString(GL_VERSION))));
    }
    if (!options.is_offscreen) SDL_GL_SetSwapInterval(1);
}

Window::Size Window::drawable_size() const {
    Size size;
    SDL_GL_GetDrawableSize(window_.get(), &size.width, &size.height);
    return size;
}

void Window::toggle_full_screen() {
    Size& before = size_before_full_screen_;
    if ((SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) == 0) {
        SDL_GetWindowSize(window_.get(), &before.width, &before.height);
        SDL_SetWindowFullscreen(window_.get(), SDL_WINDOW_FULLSCREEN_DESKTOP);
    } else {
        SDL_SetWindowFullscreen(window_.get(), 0);
        // SDL leaves that to the window manager, and there may be none.
        SDL_SetWindowSize(window_.get(), before.width, before.height);
    }
}

int Window::refresh_rate() const {
    constexpr int kUsual = 60;
    SDL_DisplayMode mode{};
    const int screen = SDL_GetWindowDisplayIndex(window_.get());
    const bool is_known = screen >= 0 && SDL_GetCurrentDisplayMode(screen, &mode) == 0;
    return is_known && mode.refresh_rate > 0 ? mode.refresh_rate : kUsual;
}

void Window::present() {
    SDL_GL_SwapWindow(window_.get());
}

}  // namespace billiards::client
