// Takes numbers; gives them as bytes, the lowest first, and back.
#pragma once

#include "common/base/check.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace billiards::base {

/// As many of its bytes as `out` has room for.
inline void put_number(std::span<std::byte> out, std::uint64_t number) {
    for (std::byte& byte : out) {
        byte = static_cast<std::byte>(number & 0xffU);
        number >>= 8U;
    }
}

/// Its lowest `size` bytes.
inline void append_number(std::vector<std::byte>& out, std::uint64_t number, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
        out.push_back(static_cast<std::byte>(number & 0xffU));
        number >>= 8U;
    }
}

/// At most 8 bytes.
inline std::uint64_t number_in(std::span<const std::byte> bytes) {
    CHECK(bytes.size() <= sizeof(std::uint64_t));
    std::uint64_t number = 0;
    for (std::size_t i = bytes.size(); i > 0; --i) {
        number = number << 8U | std::to_integer<std::uint64_t>(bytes[i - 1]);
    }
    return number;
}

}  // namespace billiards::base
