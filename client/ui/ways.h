// Takes what the menu has; goes there: starts a server in this process, connects, sits down,
// leaves. What goes wrong is said in the menu.
#pragma once

#include "client/ui/screen.h"

namespace billiards::client {

/// Two players in turn at this screen, through a server in this process.
void play_two_here(Screen& screen);
/// One player, alone with the balls, likewise.
void practise_here(Screen& screen);
void host_table(Screen& screen);
/// To the server of the menu, or by its invite to a table.
void go_to_server(Screen& screen);
void find_match(Screen& screen);
/// Back to where the profile's session was.
void resume_match(Screen& screen);
/// A table as the menu wishes it, at the server that is connected.
void open_table_there(Screen& screen);
/// To the private table of the menu's number.
void go_to_private_table(Screen& screen);
/// Back to the lobby of the server; from one in this process, to the menu.
void leave_table(Screen& screen);

/// Once a frame: keeps the session in the profile, ends a server that was left, copies an invite
/// that was asked for.
void follow_up(Screen& screen);

/// Another window plays under this profile: then it says so in the menu.
bool is_profile_taken(Screen& screen);
/// The settings that the menu wishes, on top of those that are.
match::Settings settings_of(const TableWishes& wishes, match::Settings settings = {});
/// Where others come to the table of this screen.
ServerAddress address_for_others(const Screen& screen);

}  // namespace billiards::client
