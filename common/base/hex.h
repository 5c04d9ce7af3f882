// Takes 64 bits; gives them as text.
#pragma once

#include <cstdint>
#include <string>

namespace billiards::base {

/// 16 hexadecimal digits, as every hash is shown.
inline std::string to_hex(std::uint64_t number) {
    std::string text(16, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit) {
        *digit = "0123456789abcdef"[number & 0xfU];
        number >>= 4U;
    }
    return text;
}

}  // namespace billiards::base
