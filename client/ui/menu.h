// Takes a screen; draws the menu over the table, and does what is chosen there.
#pragma once

#include "client/ui/screen.h"

namespace billiards::client {

void draw_menu(Screen& screen);

}  // namespace billiards::client
