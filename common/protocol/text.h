// Takes text from outside; gives text that is fit to be shown, or says why it is not.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace billiards::protocol {

/// NFC, without control, format, surrogate, private or unassigned code points and without line or
/// paragraph separators, at most two combining marks in a row, blanks at the ends cut off. None
/// where it is not that, or longer than `max_code_points`; an empty text is allowed.
std::optional<std::string> clean_text(std::string_view text, std::size_t max_code_points);

/// How many code points `text` has; none where it is not valid UTF-8.
std::optional<std::size_t> code_points(std::string_view text);

/// The longest start of `text` with at most `max_bytes` bytes that cuts no code point in two.
std::string_view clipped(std::string_view text, std::size_t max_bytes);

}  // namespace billiards::protocol
