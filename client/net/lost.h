// Gives the ways in which a link is lost.
#pragma once

#include <cstdint>
#include <string>

namespace billiards::client {

enum class LostCode : std::uint8_t {
    UnknownHost,
    ConnectionRefused,  ///< The host is there, and nothing listens.
    Unreachable,        ///< The network does not lead there, or another error of the system.
    NoAnswer,           ///< Not connected in time, or silent for too long.
    OtherVersion,       ///< Speaks another major version of the protocol.
    NotAServer,         ///< Something else listens there.
    Malformed,          ///< It sent bytes that are no message.
    TooMuchWaiting,     ///< It does not take what it is sent.
    Closed,             ///< By the other side.
};

struct Lost {
    LostCode code = LostCode::Closed;
    std::string reason;  ///< In words, such as "connection refused: nothing listens at [::1]:4747".

    friend bool operator==(const Lost&, const Lost&) = default;
};

}  // namespace billiards::client
