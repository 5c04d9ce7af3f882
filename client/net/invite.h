// Takes an invite; gives the link that people send each other, and back.
#pragma once

#include "client/net/address.h"
#include "common/protocol/identity.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace billiards::client {

/// SHA-256 of a server's public key. Carried along; a plain connection has nothing to hold it
/// against.
using KeyFingerprint = std::array<std::uint8_t, 32>;

/// The way to one table of one server, as "billiards://host:port/#table.secret" or
/// "billiards://host:port/#table.secret.fingerprint". Secrets stand behind the '#', which no
/// program that opens a link sends to the host. Table numbers are decimal, the rest is base64url
/// without padding (RFC 4648, section 5).
struct Invite {
    ServerAddress address;
    protocol::TableId table;
    protocol::InviteSecret secret{};
    std::optional<KeyFingerprint> fingerprint{};

    friend bool operator==(const Invite&, const Invite&) = default;
};

inline constexpr std::string_view kInviteScheme = "billiards://";
inline constexpr std::size_t kMaxHostLength = 253;  ///< Of a name: RFC 1035.
/// The longest invite that is looked at: scheme, host, brackets, port, "/#", table and secrets.
inline constexpr std::size_t kMaxInviteLength = 400;

/// None where it is anything else, or not as to_text writes it: but blanks around it, and a port
/// that is left out, are forgiven to whoever copied it.
std::optional<Invite> parse_invite(std::string_view text);
/// As parse_invite reads it.
std::string to_text(const Invite& invite);

}  // namespace billiards::client
