// Takes messages and gives bytes; takes bytes and gives a message or an error, whatever they are.
#pragma once

#include "common/base/result.h"
#include "common/protocol/messages.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace billiards::protocol {

enum class DecodeErrorCode : std::uint8_t {
    Malformed,    ///< No Cap'n Proto message within the limits.
    UnknownKind,  ///< A union member or enumerant of a newer minor version.
    OutOfBounds,  ///< A list, text or number beyond its limit; detail names the field.
};

struct DecodeError {
    DecodeErrorCode code = DecodeErrorCode::Malformed;
    std::string detail;

    friend bool operator==(const DecodeError&, const DecodeError&) = default;
};

/// One encoded frame with its length header, ready for a socket; made once, shared by every
/// receiver, never changed.
using SharedFrame = std::shared_ptr<const std::vector<std::byte>>;

SharedFrame encode(const ClientMessage& message);
SharedFrame encode(const ServerMessage& message);

/// `frame` is what follows the length header; any alignment. Never throws, never reads outside.
base::Result<ClientMessage, DecodeError> decode_client(std::span<const std::byte> frame);
base::Result<ServerMessage, DecodeError> decode_server(std::span<const std::byte> frame);

}  // namespace billiards::protocol
