// Takes a size; gives a place to draw with OpenGL 3.3: a window, or pixels without a display.
#pragma once

#include <SDL.h>
#include <memory>
#include <stdexcept>
#include <string>

namespace billiards::client {

/// No display, no OpenGL 3.3: what() says which, and the way out.
class CannotDraw : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct WindowOptions {
    std::string title = "gl-billiards";
    int width = 1280;
    int height = 720;
    bool is_offscreen = false;  ///< Through EGL, where there is no display; nothing is shown.
};

/// SDL and its OpenGL context, for as long as it lives. One at a time.
class Window {
  public:
    /// Throws CannotDraw.
    explicit Window(const WindowOptions& options);

    SDL_Window* sdl() const { return window_.get(); }
    SDL_GLContext context() const { return context_.get(); }

    struct Size {
        int width = 0;
        int height = 0;
        friend bool operator==(const Size&, const Size&) = default;
    };
    /// In pixels of the frame buffer, which may be more than the units that the mouse has.
    Size drawable_size() const;

    /// Fills the screen, and the next time is as large as it was before.
    void toggle_full_screen();

    /// Pictures a second of the screen that it is on.
    int refresh_rate() const;

    /// Shows what was drawn; waits for the screen's own rate where there is a screen.
    void present();

  private:
    struct Library {
        explicit Library(bool is_offscreen);
        ~Library();
        Library(const Library&) = delete;
        Library& operator=(const Library&) = delete;
    };
    struct CloseWindow {
        void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    };
    struct DeleteContext {
        void operator()(SDL_GLContext context) const { SDL_GL_DeleteContext(context); }
    };

    Library library_;
    std::unique_ptr<SDL_Window, CloseWindow> window_;
    std::unique_ptr<void, DeleteContext> context_;
    Size size_before_full_screen_;  ///< In the mouse's units.
};

}  // namespace billiards::client
