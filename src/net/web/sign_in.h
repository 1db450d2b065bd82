// Signs in at an archive of the web: by password, by token, or by a token that another service gives.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "net/archive/source.h"
#include "net/web/http_exchange.h"

namespace macula::net {

class WebSignIn final : public CredentialSource {
  public:
    // `settings` must outlive it.
    WebSignIn(const WebPeer& peer, const Secrets& secrets, const HttpSettings& settings);

    // Of OAuth 2 the token that was got before, until it expires.
    Result<Credentials> credentials(Progress& progress) override;
    bool renew(const Credentials& refused) override;

  private:
    Result<std::string> newToken(Progress& progress);

    WebPeer peer_;
    Secrets secrets_;
    HttpSettings tokenSettings_;  // our own certificate is for the archive alone
    std::mutex mutex_;
    std::string token_;
    std::chrono::steady_clock::time_point tokenEnds_{};
};

}  // namespace macula::net
