// TLS before a server of loopback that has none: Orthanc of Debian 12 ends with a signal at the first HTTPS
// request.
#pragma once

#include <openssl/ssl.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "net/certificates.h"

namespace macula::net::test {

class TlsFront {
  public:
    // With `trusted`, clients must show a certificate that this file trusts.
    TlsFront(const Certificate& certificate, std::uint16_t target, const std::filesystem::path& trusted = {});
    ~TlsFront();
    TlsFront(const TlsFront&) = delete;
    TlsFront& operator=(const TlsFront&) = delete;

    std::uint16_t port() const { return port_; }

  private:
    void accept();
    void serve(int client);
    int kept(int socket);

    std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)> context_;
    std::uint16_t target_;
    std::uint16_t port_ = 0;
    int listener_ = -1;
    std::atomic<bool> isOver_ = false;
    std::mutex mutex_;
    std::vector<int> sockets_;
    std::vector<std::thread> connections_;
    std::thread accepting_;
};

}  // namespace macula::net::test
