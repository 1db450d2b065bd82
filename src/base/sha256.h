// SHA-256 (FIPS 180-4), by OpenSSL.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // OpenSSL's digest context

namespace macula {

// 64 lower-case hexadecimal digits.
std::string sha256Hex(std::span<const std::byte> bytes);
std::string sha256Hex(std::string_view text);

// SHA-256 of bytes that arrive in parts.
class Sha256 {
  public:
    Sha256();
    void add(std::span<const std::byte> bytes);
    std::string hex();  // the digest of all bytes; call it once, and last

  private:
    std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

// HMAC (RFC 2104) with SHA-256: without the key nobody can compute it, or find a text by trying.
std::string hmacSha256Hex(std::span<const std::byte> key, std::string_view text);

}  // namespace macula
