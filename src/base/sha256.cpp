#include "base/sha256.h"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include "base/check.h"

namespace macula {

namespace {

// Initialises OpenSSL without its cleanup at exit: a thread that logs after that cleanup would crash in
// EVP_Digest.
void keepOpenSsl() {
    [[maybe_unused]] static const int done = OPENSSL_init_crypto(OPENSSL_INIT_NO_ATEXIT, nullptr);
}

struct Digest {
    unsigned char bytes[EVP_MAX_MD_SIZE];
    unsigned int count = 0;

    std::string hex() const {
        std::string text;
        for (unsigned int i = 0; i < count; ++i) text += fmt::format("{:02x}", bytes[i]);
        return text;
    }
};

}  // namespace

std::string sha256Hex(std::span<const std::byte> bytes) {
    keepOpenSsl();
    Digest digest;
    MACULA_CHECK(EVP_Digest(bytes.data(), bytes.size(), digest.bytes, &digest.count, EVP_sha256(), nullptr) ==
                 1);
    return digest.hex();
}

std::string sha256Hex(std::string_view text) {
    return sha256Hex(std::as_bytes(std::span(text.data(), text.size())));
}

Sha256::Sha256() : context_(nullptr, EVP_MD_CTX_free) {
    keepOpenSsl();
    context_.reset(EVP_MD_CTX_new());
    MACULA_CHECK(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
}

void Sha256::add(std::span<const std::byte> bytes) {
    MACULA_CHECK(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1);
}

std::string Sha256::hex() {
    Digest digest;
    MACULA_CHECK(EVP_DigestFinal_ex(context_.get(), digest.bytes, &digest.count) == 1);
    return digest.hex();
}

std::string hmacSha256Hex(std::span<const std::byte> key, std::string_view text) {
    keepOpenSsl();
    Digest digest;
    MACULA_CHECK(HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()),
                      reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.bytes,
                      &digest.count) != nullptr);
    return digest.hex();
}

}  // namespace macula
