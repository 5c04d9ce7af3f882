// Gives the secrets that bring a player back: made, hashed for the disk, and compared.
#pragma once

#include "common/protocol/messages.h"
#include "server/store/match_store.h"

#include <cstdint>
#include <functional>
#include <span>

namespace billiards::server {

/// Where secrets and seeds come from: the system's generator in the program, a fixed sequence in
/// tests. Fills the whole span.
using RandomBytes = std::function<void(std::span<std::uint8_t>)>;

protocol::ResumeToken new_token(const RandomBytes& random);

/// SHA-256. A token is 256 random bits, so neither salt nor stretching would add anything.
TokenHash hash_of(const protocol::ResumeToken& token);

/// Takes the same time wherever the two differ.
bool is_equal(const TokenHash& a, const TokenHash& b);

}  // namespace billiards::server
