#include "base/sha256.h"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>

#include "base/check.h"

namespace macula {

namespace {

// Initialises OpenSSL without its cleanup at exit: a thread that logs after that cleanup would crash in
// EVP_Digest.
void keepOpenSsl() {
    [[maybe_unused]] static const int done = OPENSSL_init_crypto(OPENSSL_INIT_NO_ATEXIT, nullptr);
}

}  // namespace

std::string sha256Hex(std::span<const std::byte> bytes) {
    keepOpenSsl();
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned int digestBytes = 0;
    MACULA_CHECK(EVP_Digest(bytes.data(), bytes.size(), digest, &digestBytes, EVP_sha256(), nullptr) == 1);
    std::string hex;
    for (unsigned int i = 0; i < digestBytes; ++i) hex += fmt::format("{:02x}", digest[i]);
    return hex;
}

std::string sha256Hex(std::string_view text) {
    return sha256Hex(std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace macula
