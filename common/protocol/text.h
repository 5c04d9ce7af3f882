// Takes text from outside; gives text that is fit to be shown, or says why it is not.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace billiards::protocol {

/// Valid UTF-8 without control, format, surrogate or private code points, at most two combining
/// marks in a row, blanks at the ends cut off. None where it is not valid, or longer than
/// `max_code_points`; an empty text is allowed.
std::optional<std::string> clean_text(std::string_view text, std::size_t max_code_points);

}  // namespace billiards::protocol
