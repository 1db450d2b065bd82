// Signs in at an archive of the web: by password, by token, or by a token that another service gives.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <string>

#include "net/archive/source.h"
#include "net/web/http_exchange.h"
#include "net/web/token_service.h"

namespace macula::net {

// Told the secrets with a refresh token that took the place of the one before: without keeping it, a person
// would have to sign in again. Called by any thread that makes requests.
using KeepSecrets = std::function<void(const Secrets&)>;

class WebSignIn final : public CredentialSource {
  public:
    WebSignIn(const WebPeer& peer, const Secrets& secrets, const HttpSettings& settings, KeepSecrets keep);

    // Of OAuth 2 the token that was got before, until it expires.
    Result<Credentials> credentials(Progress& progress) override;
    bool renew(const Credentials& refused) override;

  private:
    bool usesTokenService() const;
    Result<void> getToken(Progress& progress);
    Result<TokenAnswer> refreshed(Progress& progress);

    WebPeer peer_;
    Secrets secrets_;
    HttpSettings tokenSettings_;
    KeepSecrets keep_;
    std::mutex mutex_;
    std::string token_;
    std::chrono::steady_clock::time_point tokenEnds_{};
};

}  // namespace macula::net
