// Gives every control that is on the screen its name and its place: for reports, and so for whoever
// drives the program from outside.
#pragma once

#include <imgui.h>
#include <map>
#include <string>

namespace billiards::client {

/// In window units, as the mouse has them.
struct ControlPlace {
    float left = 0;
    float top = 0;
    float width = 0;
    float height = 0;

    friend bool operator==(const ControlPlace&, const ControlPlace&) = default;
};

/// The controls of one frame.
class ControlMap {
  public:
    void start_frame() { places_.clear(); }
    /// Of the item that was just made, unless it is scrolled out of sight.
    void note(const std::string& name) {
        if (!ImGui::IsItemVisible()) return;
        const ImVec2 from = ImGui::GetItemRectMin();
        const ImVec2 to = ImGui::GetItemRectMax();
        places_[name] = {from.x, from.y, to.x - from.x, to.y - from.y};
    }
    const std::map<std::string, ControlPlace>& places() const { return places_; }

  private:
    std::map<std::string, ControlPlace> places_;
};

}  // namespace billiards::client
