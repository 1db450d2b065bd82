// Certificates for servers and programs of a test, made when it runs.
#pragma once

#include <filesystem>
#include <string>

namespace macula::net::test {

// PEM files of one certificate and its key.
struct Certificate {
    std::filesystem::path certificate;
    std::filesystem::path key;
};

struct CertificateOptions {
    std::string host = "127.0.0.1";  // a name or an address of IPv4, which the certificate is for
    bool isExpired = false;
    std::string keyPassphrase;  // empty: the key is not encrypted
};

// An authority of its own, which signs certificates.
class Authority {
  public:
    explicit Authority(const std::filesystem::path& folder);
    // The file to trust it by.
    const std::filesystem::path& file() const { return own_.certificate; }
    Certificate sign(const std::string& name, const CertificateOptions& options = {}) const;

  private:
    std::filesystem::path folder_;
    Certificate own_;
};

}  // namespace macula::net::test
