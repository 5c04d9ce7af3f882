// Takes a stream of bytes; gives preambles and frames, or the reason why it holds none.
#pragma once

#include "common/base/result.h"
#include "common/protocol/limits.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace billiards::protocol {

enum class FramingErrorCode : std::uint8_t {
    BadMagic,        ///< The other side does not speak this protocol at all.
    OtherVersion,    ///< It speaks another major version; detail names both.
    BadFrameLength,  ///< No multiple of 8, or 0.
    FrameTooLong,
};

struct FramingError {
    FramingErrorCode code = FramingErrorCode::BadMagic;
    std::string detail;

    friend bool operator==(const FramingError&, const FramingError&) = default;
};

/// 16 bytes that each side sends first, whatever its version: "GLBILLRD", u16 major, u16 minor,
/// u32 feature bits, little-endian.
inline constexpr std::size_t kPreambleBytes = 16;
using PreambleBytes = std::array<std::byte, kPreambleBytes>;

struct Preamble {
    std::uint16_t major = kVersionMajor;
    std::uint16_t minor = kVersionMinor;
    std::uint32_t features = 0;

    friend bool operator==(const Preamble&, const Preamble&) = default;
};

PreambleBytes encode_preamble(const Preamble& preamble);
/// Any two versions can read each other's preamble; another major is an error that names both.
base::Result<Preamble, FramingError> decode_preamble(
    std::span<const std::byte, kPreambleBytes> bytes);

using FrameHeader = std::array<std::byte, kFrameHeaderBytes>;

/// The length of the frame that follows, in bytes.
base::Result<std::size_t, FramingError> decode_frame_header(
    std::span<const std::byte, kFrameHeaderBytes> header, std::size_t max_frame_bytes);
FrameHeader encode_frame_header(std::size_t frame_bytes);

}  // namespace billiards::protocol
