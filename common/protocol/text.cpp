// Takes text from outside; gives it in NFC when every code point may be shown.
#include "common/protocol/text.h"

#include <cstdlib>
#include <memory>
#include <utf8proc.h>

namespace billiards::protocol {

namespace {

constexpr int kMaxMarksInARow = 2;

/// Calls visit(code point) for each; false where the text is not valid UTF-8 or visit says so.
template <class Visit>
bool for_each_code_point(std::string_view text, Visit visit) {
    const auto* at = reinterpret_cast<const utf8proc_uint8_t*>(text.data());
    auto left = static_cast<utf8proc_ssize_t>(text.size());
    while (left > 0) {
        utf8proc_int32_t code_point = 0;
        const utf8proc_ssize_t used = utf8proc_iterate(at, left, &code_point);
        if (used <= 0 || !visit(code_point)) return false;
        at += used;
        left -= used;
    }
    return true;
}

bool is_mark(utf8proc_category_t category) {
    return category == UTF8PROC_CATEGORY_MN || category == UTF8PROC_CATEGORY_MC ||
           category == UTF8PROC_CATEGORY_ME;
}

bool is_showable(utf8proc_category_t category) {
    switch (category) {
        case UTF8PROC_CATEGORY_CN:  // Unassigned.
        case UTF8PROC_CATEGORY_CC:  // Control.
        case UTF8PROC_CATEGORY_CF:  // Format: also what turns the direction of writing.
        case UTF8PROC_CATEGORY_CS:  // Surrogate.
        case UTF8PROC_CATEGORY_CO:  // Private use.
        case UTF8PROC_CATEGORY_ZL:  // Line and paragraph separators.
        case UTF8PROC_CATEGORY_ZP:
            return false;
        default:
            return true;
    }
}

bool is_fit(std::string_view text, std::size_t max_code_points) {
    std::size_t length = 0;
    int marks = 0;
    return for_each_code_point(text, [&](utf8proc_int32_t code_point) {
        const utf8proc_category_t category = utf8proc_category(code_point);
        marks = is_mark(category) ? marks + 1 : 0;
        return is_showable(category) && marks <= kMaxMarksInARow && ++length <= max_code_points;
    });
}

std::optional<std::string> normalized(std::string_view text) {
    utf8proc_uint8_t* composed = nullptr;
    const utf8proc_ssize_t size =
        utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                     static_cast<utf8proc_ssize_t>(text.size()), &composed,
                     static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE));
    const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(composed, &std::free);
    if (size < 0) return std::nullopt;
    return std::string(reinterpret_cast<const char*>(composed), static_cast<std::size_t>(size));
}

/// The text without the blanks (Unicode's Zs) at its ends. It is valid UTF-8.
std::string_view trimmed(std::string_view text) {
    std::size_t at = 0;
    std::size_t first = text.size();
    std::size_t end = 0;
    for_each_code_point(text, [&](utf8proc_int32_t code_point) {
        utf8proc_uint8_t encoded[4];
        const auto size = static_cast<std::size_t>(utf8proc_encode_char(code_point, encoded));
        if (utf8proc_category(code_point) != UTF8PROC_CATEGORY_ZS) {
            if (first == text.size()) first = at;
            end = at + size;
        }
        at += size;
        return true;
    });
    return first < end ? text.substr(first, end - first) : std::string_view();
}

}  // namespace

std::optional<std::string> clean_text(std::string_view text, std::size_t max_code_points) {
    const std::optional<std::string> composed = normalized(text);
    if (!composed) return std::nullopt;
    const std::string_view shown = trimmed(*composed);
    if (!is_fit(shown, max_code_points)) return std::nullopt;
    return std::string(shown);
}

std::optional<std::size_t> code_points(std::string_view text) {
    std::size_t count = 0;
    const bool is_valid = for_each_code_point(text, [&](utf8proc_int32_t) { return ++count > 0; });
    return is_valid ? std::optional(count) : std::nullopt;
}

std::string_view clipped(std::string_view text, std::size_t max_bytes) {
    if (text.size() <= max_bytes) return text;
    std::size_t end = max_bytes;
    const auto continues = [&](std::size_t at) {
        return (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U;
    };
    while (end > 0 && continues(end)) --end;
    return text.substr(0, end);
}

}  // namespace billiards::protocol
