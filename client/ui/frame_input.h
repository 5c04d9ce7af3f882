// Takes SDL's events one by one; says which of them one frame takes, and where the mouse is in it.
#pragma once

#include <SDL_events.h>
#include <SDL_scancode.h>
#include <array>
#include <imgui.h>
#include <optional>
#include <vector>

namespace billiards::client {

/// ImGui 1.86 looks at keys and mouse once a frame. On a slow machine it would miss a short tap,
/// take it for one without the Shift under which it was done, or a click for a pull of the cue,
/// because the mouse had moved on before anybody looked. So a frame takes events up to the second
/// change of one key or button, until Shift or Ctrl changes under what was done before, and until
/// the mouse leaves the place of a press or a release.
class FrameInput {
  public:
    void start_frame();
    /// True where this frame takes the event; false: the next one, and all that follow.
    bool take(const SDL_Event& event);
    /// Puts ImGui's mouse to where the events have left it. Its backend asks the system instead,
    /// which is ahead of them.
    void place_mouse(ImGuiIO& io) const;

  private:
    bool is_for_next(const SDL_Event& event) const;
    void follow_mouse(const SDL_Event& event);
    bool is_held() const;

    std::vector<SDL_Scancode> keys_;  ///< That changed in this frame.
    std::vector<Uint8> buttons_;      ///< As keys_.
    bool is_empty_ = true;            ///< Nothing was taken in this frame yet.
    /// Far away where the mouse is over another window; none until it has been felt.
    std::optional<ImVec2> mouse_;
    std::array<bool, ImGuiMouseButton_COUNT> held_{};
};

}  // namespace billiards::client
