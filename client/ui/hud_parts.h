// Takes a screen and its table; draws one part each of what stands over the table in words.
#pragma once

#include "client/ui/screen.h"

namespace billiards::client {

inline constexpr float kStripMargin =
    10.0F;  ///< Between a strip and the window's edge, or another.

/// A strip of its own, in the middle of the table; words alone let the mouse through to the balls.
/// ImGui::End() ends it.
void begin_strip(const Screen& screen, const char* name, float from_top,
                 ImGuiWindowFlags flags = ImGuiWindowFlags_NoInputs);

/// Who plays, the score and the clock; below what follows, and what else is to be known.
void draw_score(Screen& screen, const TableView& table);
/// What may be asked for or must be answered now, as buttons.
void draw_asks(Screen& screen, const TableView& table);
/// For whoever does not play: from the start, shot by shot, and back to the live match.
void draw_rewatch(Screen& screen, const TableView& table);
/// What is said at the table, and a line to say something.
void draw_talk(Screen& screen, const TableView& table);

}  // namespace billiards::client
