// Takes a screen; draws the panel at its right edge, with every control of the original design, and
// does what its controls say.
#pragma once

#include "client/ui/screen.h"

namespace billiards::client {

void draw_panel(Screen& screen);

}  // namespace billiards::client
