// Takes an address as text; gives host and port, and back.
#include "client/net/address.h"

#include <algorithm>
#include <charconv>

namespace billiards::client {

namespace {

std::optional<std::uint16_t> parse_port(std::string_view text) {
    std::uint16_t port = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
    if (error != std::errc() || end != text.data() + text.size() || port == 0) return std::nullopt;
    return port;
}

std::optional<ServerAddress> with_port(std::string_view host, std::string_view port_text) {
    const std::optional<std::uint16_t> port = parse_port(port_text);
    if (host.empty() || !port) return std::nullopt;
    return ServerAddress{.host = std::string(host), .port = *port};
}

}  // namespace

std::optional<ServerAddress> parse_address(std::string_view text) {
    if (text.empty()) return std::nullopt;
    if (text.front() == '[') {
        const std::size_t close = text.find(']');
        if (close == std::string_view::npos || close == 1) return std::nullopt;
        const std::string_view host = text.substr(1, close - 1);
        const std::string_view rest = text.substr(close + 1);
        if (rest.empty()) return ServerAddress{.host = std::string(host)};
        return rest.front() == ':' ? with_port(host, rest.substr(1)) : std::nullopt;
    }
    const auto colons = std::count(text.begin(), text.end(), ':');
    if (colons != 1) return ServerAddress{.host = std::string(text)};  // A name, or bare IPv6.
    const std::size_t colon = text.find(':');
    return with_port(text.substr(0, colon), text.substr(colon + 1));
}

std::string to_text(const ServerAddress& address) {
    const bool is_ipv6 = address.host.find(':') != std::string::npos;
    return (is_ipv6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

}  // namespace billiards::client
