// Takes a screen; draws the menu over the table, and does what is chosen there.
#pragma once

#include "client/ui/screen.h"

namespace billiards::client {

void draw_menu(Screen& screen);

/// Two players in turn at this screen, through a server in this process.
void play_two_here(Screen& screen);

}  // namespace billiards::client
