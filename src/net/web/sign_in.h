// Signs in at an archive of the web: by password, by token, or by a token that another service gives.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "net/archive/token_renewal.h"
#include "net/web/http_exchange.h"
#include "net/web/token_service.h"

namespace macula::net {

class WebSignIn final : public CredentialSource {
  public:
    WebSignIn(const WebPeer& peer, const Secrets& secrets, const HttpSettings& settings, RenewTokens renew);

    // Of OAuth 2 the token that was got before, until it expires.
    Result<Credentials> credentials(Progress& progress) override;
    bool renew(const Credentials& refused) override;

  private:
    bool usesTokenService() const;
    Result<void> getToken(Progress& progress);
    Result<void> refresh(Progress& progress);
    void use(const std::string& token, std::chrono::seconds life);

    WebPeer peer_;
    Secrets secrets_;
    HttpSettings tokenSettings_;
    RenewTokens renew_;  // empty: nobody else has the sign-in
    std::mutex mutex_;
    std::string token_;
    std::chrono::steady_clock::time_point tokenEnds_{};
};

}  // namespace macula::net
