// Takes and gives the bytes around a message: the preamble, and each frame's length.
#include "common/protocol/framing.h"

#include "common/base/little_endian.h"

#include <algorithm>
#include <string_view>

namespace billiards::protocol {

namespace {

constexpr std::string_view kMagic = "GLBILLRD";
constexpr std::size_t kMajorAt = 8;
constexpr std::size_t kMinorAt = 10;
constexpr std::size_t kFeaturesAt = 12;
constexpr std::size_t kWordBytes = 8;

std::string in_words(std::uint16_t major, std::uint16_t minor) {
    return std::to_string(major) + "." + std::to_string(minor);
}

}  // namespace

PreambleBytes encode_preamble(const Preamble& preamble) {
    PreambleBytes bytes{};
    std::transform(kMagic.begin(), kMagic.end(), bytes.begin(),
                   [](char letter) { return static_cast<std::byte>(letter); });
    const std::span<std::byte> all(bytes);
    base::put_number(all.subspan(kMajorAt, 2), preamble.major);
    base::put_number(all.subspan(kMinorAt, 2), preamble.minor);
    base::put_number(all.subspan(kFeaturesAt, 4), preamble.features);
    return bytes;
}

base::Result<Preamble, FramingError> decode_preamble(
    std::span<const std::byte, kPreambleBytes> bytes) {
    const bool is_ours = std::equal(
        kMagic.begin(), kMagic.end(), bytes.begin(),
        [](char letter, std::byte byte) { return static_cast<std::byte>(letter) == byte; });
    if (!is_ours) return FramingError{FramingErrorCode::BadMagic, "does not begin with GLBILLRD"};
    const Preamble preamble{
        .major = static_cast<std::uint16_t>(base::number_in(bytes.subspan(kMajorAt, 2))),
        .minor = static_cast<std::uint16_t>(base::number_in(bytes.subspan(kMinorAt, 2))),
        .features = static_cast<std::uint32_t>(base::number_in(bytes.subspan(kFeaturesAt, 4)))};
    if (preamble.major != kVersionMajor) {
        return FramingError{FramingErrorCode::OtherVersion,
                            "the other side speaks version " +
                                in_words(preamble.major, preamble.minor) + ", this side " +
                                in_words(kVersionMajor, kVersionMinor)};
    }
    return preamble;
}

base::Result<std::size_t, FramingError> decode_frame_header(
    std::span<const std::byte, kFrameHeaderBytes> header, std::size_t max_frame_bytes) {
    const std::size_t length = base::number_in(header);
    if (length == 0 || length % kWordBytes != 0) {
        return FramingError{FramingErrorCode::BadFrameLength,
                            std::to_string(length) + " bytes are no multiple of 8 above 0"};
    }
    if (length > max_frame_bytes) {
        return FramingError{
            FramingErrorCode::FrameTooLong,
            std::to_string(length) + " bytes, allowed are " + std::to_string(max_frame_bytes)};
    }
    return length;
}

FrameHeader encode_frame_header(std::size_t frame_bytes) {
    CHECK(frame_bytes > 0 && frame_bytes % kWordBytes == 0 && frame_bytes <= 0xffffffffU);
    FrameHeader header{};
    base::put_number(header, frame_bytes);
    return header;
}

}  // namespace billiards::protocol
