// Takes what is typed or pasted; drops what is too much at its end.
#include "client/ui/text_input.h"

#include <imgui.h>
#include <imgui_stdlib.h>

namespace billiards::client {

namespace {

bool begins_letter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

int cut_off(ImGuiInputTextCallbackData* data) {
    auto left = *static_cast<const std::size_t*>(data->UserData);
    for (int i = 0; i < data->BufTextLen; ++i) {
        if (!begins_letter(data->Buf[i]) || left-- > 0) continue;
        data->DeleteChars(i, data->BufTextLen - i);
        return 0;
    }
    return 0;
}

}  // namespace

bool text_input(const char* id, const char* hint, std::string& text, std::size_t most) {
    return ImGui::InputTextWithHint(
        id, hint, &text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackEdit,
        cut_off, &most);
}

}  // namespace billiards::client
