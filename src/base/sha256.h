// SHA-256 (FIPS 180-4), by OpenSSL.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // of OpenSSL

namespace macula {

// 64 lower-case hexadecimal digits.
std::string sha256Hex(std::span<const std::byte> bytes);
std::string sha256Hex(std::string_view text);

// The same of bytes that come in parts.
class Sha256 {
  public:
    Sha256();
    void add(std::span<const std::byte> bytes);
    std::string hex();  // of all of them; once, and last

  private:
    std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

// HMAC (RFC 2104) with SHA-256: who does not have the key can neither make it nor try texts out.
std::string hmacSha256Hex(std::span<const std::byte> key, std::string_view text);

}  // namespace macula
