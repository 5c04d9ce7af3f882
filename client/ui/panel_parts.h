// Takes a screen; draws one group of the panel, and gives what several groups are drawn with.
#pragma once

#include "client/ui/screen.h"

namespace billiards::client {

/// Rotate Cue, Shoot, Power, Spin, Elevation and Call.
void draw_cue_group(Screen& screen);

float full_width();
ImU32 ink();
/// A line with a head at its end, to be dragged that way.
void draw_arrow(const Screen& screen, const ImVec2& from, const ImVec2& to);
ImVec2 middle_of_last_item();
/// How far the mouse was dragged since the last frame, while the control is held. The way to it is
/// no drag, even where a slow frame saw both at once.
ImVec2 drag_on_last_item();

}  // namespace billiards::client
