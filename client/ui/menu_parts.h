// Takes a screen and words; draws the few kinds of controls that the menu's pages are made of.
#pragma once

#include "client/ui/screen.h"

#include <array>
#include <string>

namespace billiards::client {

/// True where it was clicked.
bool wide_button(Screen& screen, const char* name);
/// Two of them side by side: the first of a row keeps its place for the second.
bool half_button(Screen& screen, const char* name, bool is_second);
/// True where Enter ends it: the page does then what it is for. Never more than `most` letters.
bool text_field(Screen& screen, const char* name, std::string& text, std::size_t most,
                const char* hint = "");
void quiet_line(const Screen& screen, const char* text);
void check_box(Screen& screen, const char* text, const char* name, bool& value);
void open(Screen& screen, MenuPage page);
/// What the server would not do is the page's trouble.
void say_refusal(Screen& screen);
void draw_back(Screen& screen, MenuPage to = MenuPage::Main);
/// Game, race, table, spectators' delay, and whether it is private.
void draw_wishes(Screen& screen);
void draw_games(Screen& screen);

// The pages; each draws itself and does what is clicked on it.
void draw_main_page(Screen& screen);
void draw_host_page(Screen& screen);
void draw_quick_page(Screen& screen);
void draw_join_page(Screen& screen);
void draw_tables_page(Screen& screen);
void draw_private_page(Screen& screen);
void draw_open_page(Screen& screen);
void draw_table_page(Screen& screen);
void draw_help_page(Screen& screen);

}  // namespace billiards::client
