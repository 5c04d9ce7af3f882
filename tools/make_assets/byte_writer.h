// Takes numbers and text; gives them as little-endian bytes.
#pragma once

#include "common/base/little_endian.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace billiards::make_assets {

using Bytes = std::vector<std::byte>;

class ByteWriter {
  public:
    void u8(std::uint8_t value) { bytes_.push_back(static_cast<std::byte>(value)); }
    void u16(std::uint16_t value) { base::append_number(bytes_, value, sizeof value); }
    void u32(std::uint32_t value) { base::append_number(bytes_, value, sizeof value); }
    void f32(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
    /// With a zero byte behind it.
    void text(std::string_view text) {
        for (const char c : text) u8(static_cast<std::uint8_t>(c));
        u8(0);
    }
    void append(const Bytes& bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

    Bytes take() && { return std::move(bytes_); }

  private:
    Bytes bytes_;
};

}  // namespace billiards::make_assets
