// Takes an address as people write it; gives an endpoint, and back.
#pragma once

#include <asio/ip/tcp.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace billiards::server {

using Endpoint = asio::ip::tcp::endpoint;

/// "127.0.0.1:4747" or "[::1]:4747"; numbers only, since a name may mean another host tomorrow.
/// None where it is neither.
std::optional<Endpoint> parse_endpoint(std::string_view text);

/// As parse_endpoint reads it.
std::string to_text(const Endpoint& endpoint);

/// Only this machine can reach it; an IPv4 address inside an IPv6 one counts as what it is.
bool is_loopback(const asio::ip::address& address);

}  // namespace billiards::server
