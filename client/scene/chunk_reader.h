// Takes bytes that nobody vouches for; gives the chunks of a .3ds file and the little-endian
// numbers in them, never a byte beyond.
#pragma once

#include "common/base/check.h"
#include "common/base/little_endian.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace billiards::client {

/// What is left to read of a piece of a file. Ask has() first: reading beyond is our mistake.
class ByteReader {
  public:
    ByteReader(std::span<const std::byte> bytes, std::size_t at_byte)
        : bytes_(bytes), at_byte_(at_byte) {}

    bool empty() const { return bytes_.empty(); }
    bool has(std::size_t size) const { return bytes_.size() >= size; }
    std::size_t left() const { return bytes_.size(); }
    /// Where in the file the next byte lies.
    std::size_t at_byte() const { return at_byte_; }

    std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
    std::uint32_t u32() { return number(4); }
    float f32() { return std::bit_cast<float>(u32()); }

    ByteReader take(std::size_t size) {
        CHECK(has(size));
        const ByteReader taken(bytes_.first(size), at_byte_);
        bytes_ = bytes_.subspan(size);
        at_byte_ += size;
        return taken;
    }

    /// Text up to its zero byte, which is read too; none where there is no zero byte within
    /// `longest` characters.
    std::optional<std::string> text(std::size_t longest) {
        std::string text;
        for (std::size_t i = 0; i < bytes_.size() && i <= longest; ++i) {
            if (bytes_[i] == std::byte{0}) return take(i + 1), text;
            text += static_cast<char>(bytes_[i]);
        }
        return std::nullopt;
    }

  private:
    std::uint32_t number(std::size_t size) {
        return static_cast<std::uint32_t>(base::number_in(take(size).bytes_));
    }

    std::span<const std::byte> bytes_;
    std::size_t at_byte_;
};

struct Chunk {
    std::uint16_t id = 0;
    std::size_t at_byte = 0;  ///< Where its head lies in the file.
    ByteReader body;
};

/// The next chunk of a parent; none where its length does not fit into the parent.
inline std::optional<Chunk> next_chunk(ByteReader& parent) {
    constexpr std::size_t kHeadBytes = 6;  // Identifier and length; the length counts them.
    if (!parent.has(kHeadBytes)) return std::nullopt;
    const std::size_t at_byte = parent.at_byte();
    const std::uint16_t id = parent.u16();
    const std::size_t length = parent.u32();
    if (length < kHeadBytes || !parent.has(length - kHeadBytes)) return std::nullopt;
    return Chunk{id, at_byte, parent.take(length - kHeadBytes)};
}

}  // namespace billiards::client
