// Gives the secrets that bring a player back: made, hashed for the disk, and compared.
#pragma once

#include "common/protocol/messages.h"
#include "server/store/match_store.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace billiards::server {

/// Where secrets and seeds come from: the system's generator in the program, a fixed sequence in
/// tests. Fills the whole span.
using RandomBytes = std::function<void(std::span<std::uint8_t>)>;

protocol::ResumeToken new_token(const RandomBytes& random);

/// SHA-256. A token is 256 random bits, so neither salt nor stretching would add anything.
TokenHash hash_of(const protocol::ResumeToken& token);

protocol::InviteSecret new_invite(const RandomBytes& random);

/// SHA-256, for the reason given above.
SecretHash hash_of(const protocol::InviteSecret& invite);

using Salt = std::array<std::uint8_t, 16>;

/// SHA-256 of the salt and the passcode after it, so that equal passcodes of two tables do not
/// look equal. Whoever reads the database can try passcodes out; only few can be tried from
/// outside.
SecretHash hash_of(const Salt& salt, std::string_view passcode);

/// Takes the same time wherever the two differ.
bool is_equal(const TokenHash& a, const TokenHash& b);

}  // namespace billiards::server
