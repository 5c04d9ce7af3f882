// Takes random bytes and secrets; gives secrets and their hashes, by OpenSSL.
#include "server/session/token.h"

#include "common/base/check.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <vector>

namespace billiards::server {
namespace {

std::array<std::uint8_t, 32> sha256(std::span<const std::uint8_t> bytes) {
    std::array<std::uint8_t, 32> hash{};
    unsigned int length = 0;
    // Fails only where the library cannot allocate or lacks SHA-256.
    CHECK(EVP_Digest(bytes.data(), bytes.size(), hash.data(), &length, EVP_sha256(), nullptr) == 1);
    CHECK(length == hash.size());
    return hash;
}

}  // namespace

protocol::ResumeToken new_token(const RandomBytes& random) {
    protocol::ResumeToken token{};
    random(token);
    return token;
}

protocol::InviteSecret new_invite(const RandomBytes& random) {
    protocol::InviteSecret invite{};
    random(invite);
    return invite;
}

TokenHash hash_of(const protocol::ResumeToken& token) {
    return sha256(token);
}

SecretHash hash_of(const protocol::InviteSecret& invite) {
    return sha256(invite);
}

SecretHash hash_of(const Salt& salt, std::string_view passcode) {
    std::vector<std::uint8_t> salted(salt.begin(), salt.end());
    salted.insert(salted.end(), passcode.begin(), passcode.end());
    return sha256(salted);
}

bool is_equal(const TokenHash& a, const TokenHash& b) {
    return CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace billiards::server
