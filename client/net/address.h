// Takes "host:port" as people write it; gives the two parts.
#pragma once

#include "common/protocol/limits.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace billiards::client {

struct ServerAddress {
    std::string host;  ///< A name or a numeric address, without brackets.
    std::uint16_t port = protocol::kDefaultPort;

    friend bool operator==(const ServerAddress&, const ServerAddress&) = default;
};

/// "host", "host:port", "1.2.3.4:port", "[::1]:port", "::1". None where it is none of these.
std::optional<ServerAddress> parse_address(std::string_view text);
/// As parse_address reads it.
std::string to_text(const ServerAddress& address);

}  // namespace billiards::client
