// Takes a screen; draws over the table what players must see there: names, score and clock, where
// the shot would go, what is held and called, and the choices.
#pragma once

#include "client/ui/screen.h"

namespace billiards::client {

void draw_hud(Screen& screen);

}  // namespace billiards::client
