// Takes bytes that are kept for long; gives them packed by zstd, and back.
#include "common/protocol/packing.h"

#include "common/base/check.h"

#include <algorithm>
#include <array>
#include <string>
#include <zstd.h>

namespace billiards::protocol {

namespace {

using Bytes = std::vector<std::byte>;

/// Higher ones take twice the time for a hundredth of the size: a record is mostly mantissas.
constexpr int kLevel = 3;
/// RFC 8878, 3.1.1: Magic_Number, little-endian.
constexpr std::array kMagic{std::byte{0x28}, std::byte{0xb5}, std::byte{0x2f}, std::byte{0xfd}};

bool is_packed(std::span<const std::byte> bytes) {
    return bytes.size() >= kMagic.size() &&
           std::ranges::equal(bytes.first<kMagic.size()>(), kMagic);
}

}  // namespace

Bytes packed(std::span<const std::byte> bytes) {
    if (bytes.empty()) return {};
    Bytes out(ZSTD_compressBound(bytes.size()));
    const std::size_t size =
        ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
    CHECK(ZSTD_isError(size) == 0);
    out.resize(size);
    return out;
}

base::Result<Bytes, DecodeError> unpacked(std::span<const std::byte> bytes, std::size_t max_bytes) {
    const bool is_plain = !is_packed(bytes);
    const unsigned long long size =
        is_plain ? bytes.size() : ZSTD_getFrameContentSize(bytes.data(), bytes.size());
    if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR) {
        return DecodeError{DecodeErrorCode::Malformed, "packed bytes without their size"};
    }
    if (size > max_bytes) {
        return DecodeError{
            DecodeErrorCode::OutOfBounds,
            std::to_string(size) + " packed bytes, over the limit of " + std::to_string(max_bytes)};
    }
    if (is_plain) return Bytes(bytes.begin(), bytes.end());
    Bytes out(static_cast<std::size_t>(size));
    const std::size_t got = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
    if (ZSTD_isError(got) != 0 || got != out.size()) {
        return DecodeError{DecodeErrorCode::Malformed, "packed bytes are damaged"};
    }
    return out;
}

}  // namespace billiards::protocol
