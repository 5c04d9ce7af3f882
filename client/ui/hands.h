// Takes mouse and keys over the table; aims, shoots, places, calls, and moves the eye.
#pragma once

#include "client/ui/screen.h"

#include <optional>

namespace billiards::client {

/// What the hands hold between two frames.
class Hands {
  public:
    /// Once a frame, after the panel and the menu have taken what is theirs.
    void handle(Screen& screen);

  private:
    enum class Hold : std::uint8_t { Nothing, Cue, CueBall, Eye, Ball };

    void handle_mouse(Screen& screen);
    void press(Screen& screen, base::Vec2 on_bed_m);
    void drag(Screen& screen, const std::optional<base::Vec2>& on_bed_m);
    void release(Screen& screen);
    void click(Screen& screen);
    void drop_ball(Screen& screen) const;
    void handle_wheel(Screen& screen) const;
    void handle_keys(Screen& screen);
    void press_spin_key(Screen& screen);
    void handle_arrows(Screen& screen) const;

    Hold hold_ = Hold::Nothing;
    ImVec2 pressed_at_{};
    base::Vec2 pressed_on_bed_m_{};
    std::optional<base::Instant> spin_key_at_;
};

/// The place on the screen, from (-1, -1) to (1, 1), of a point in window units.
base::Vec2 place_of(const Screen& screen, const ImVec2& point);
/// And back.
ImVec2 point_of(const Screen& screen, base::Vec2 place);
double aspect_of(const Screen& screen);

}  // namespace billiards::client
