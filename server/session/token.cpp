// Takes random bytes and tokens; gives tokens and their hashes, by OpenSSL.
#include "server/session/token.h"

#include "common/base/check.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>

namespace billiards::server {

protocol::ResumeToken new_token(const RandomBytes& random) {
    protocol::ResumeToken token{};
    random(token);
    return token;
}

TokenHash hash_of(const protocol::ResumeToken& token) {
    TokenHash hash{};
    unsigned int length = 0;
    // Fails only where the library cannot allocate or lacks SHA-256.
    CHECK(EVP_Digest(token.data(), token.size(), hash.data(), &length, EVP_sha256(), nullptr) == 1);
    CHECK(length == hash.size());
    return hash;
}

bool is_equal(const TokenHash& a, const TokenHash& b) {
    return CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace billiards::server
