// Takes SDL's events; gives what of them ImGui sees at once.
#include "client/ui/frame_input.h"

#include <algorithm>
#include <cfloat>

namespace billiards::client {

namespace {

bool is_modifier(SDL_Scancode key) {
    return SDL_SCANCODE_LCTRL <= key && key <= SDL_SCANCODE_RGUI;
}

bool is_change_of_key(const SDL_Event& event) {
    return (event.type == SDL_KEYDOWN || event.type == SDL_KEYUP) && event.key.repeat == 0;
}

bool is_change_of_button(const SDL_Event& event) {
    return event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP;
}

ImVec2 point(Sint32 x, Sint32 y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

/// As ImGui counts them; none of those that it does not.
std::optional<std::size_t> button_of(const SDL_Event& event) {
    switch (event.button.button) {
        case SDL_BUTTON_LEFT:
            return ImGuiMouseButton_Left;
        case SDL_BUTTON_RIGHT:
            return ImGuiMouseButton_Right;
        case SDL_BUTTON_MIDDLE:
            return ImGuiMouseButton_Middle;
        default:
            return std::nullopt;
    }
}

}  // namespace

void FrameInput::start_frame() {
    keys_.clear();
    buttons_.clear();
    is_empty_ = true;
}

bool FrameInput::take(const SDL_Event& event) {
    if (is_for_next(event)) return false;
    if (is_change_of_key(event)) keys_.push_back(event.key.keysym.scancode);
    if (is_change_of_button(event)) buttons_.push_back(event.button.button);
    follow_mouse(event);
    is_empty_ = false;
    return true;
}

bool FrameInput::is_for_next(const SDL_Event& event) const {
    if (is_change_of_key(event)) {
        const SDL_Scancode key = event.key.keysym.scancode;
        const bool is_second = std::ranges::find(keys_, key) != keys_.end();
        return is_second || (is_modifier(key) && !is_empty_);
    }
    if (is_change_of_button(event)) {
        return std::ranges::find(buttons_, event.button.button) != buttons_.end();
    }
    return event.type == SDL_MOUSEMOTION && !buttons_.empty();
}

void FrameInput::follow_mouse(const SDL_Event& event) {
    if (event.type == SDL_MOUSEMOTION) {
        mouse_ = point(event.motion.x, event.motion.y);
    } else if (is_change_of_button(event)) {
        mouse_ = point(event.button.x, event.button.y);
        if (const auto button = button_of(event)) {
            held_.at(*button) = event.type == SDL_MOUSEBUTTONDOWN;
        }
    } else if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_LEAVE) {
        if (!is_held()) mouse_ = ImVec2{-FLT_MAX, -FLT_MAX};
    }
}

bool FrameInput::is_held() const {
    return std::ranges::find(held_, true) != held_.end();
}

void FrameInput::place_mouse(ImGuiIO& io) const {
    if (mouse_) io.MousePos = *mouse_;
    std::ranges::copy(held_, io.MouseDown);
}

}  // namespace billiards::client
