// Takes a text and its longest length; draws a field to type it in.
#pragma once

#include <cstddef>
#include <string>

namespace billiards::client {

/// True where Enter ends it. Never holds more than `most` code points: a server cuts off whoever
/// sends it more.
bool text_input(const char* id, const char* hint, std::string& text, std::size_t most);

}  // namespace billiards::client
