#include "net/web/sign_in.h"

#include <algorithm>
#include <utility>

#include "net/web/web_address.h"

namespace macula::net {

namespace {

using Clock = std::chrono::steady_clock;

// A token may last shorter than it says: it is asked for again a little before its end.
constexpr std::chrono::seconds kSpareOfToken{30};
// Of a token that another has got: it is used until it is refused.
constexpr std::chrono::seconds kLifeUnknown{3600};

Error signInAgain() {
    return {ErrorCode::archiveNotUsable,
            Text("The sign-in at the archive is over."),
            {},
            Text("Sign in again: in the settings of the archive, or by macula pacs sign-in.")};
}

}  // namespace

WebSignIn::WebSignIn(const WebPeer& peer, const Secrets& secrets, const HttpSettings& settings,
                     RenewTokens renew)
    : peer_(peer),
      secrets_(secrets),
      tokenSettings_(withoutOwnCertificate(settings)),
      renew_(std::move(renew)) {
    // The token of the sign-in itself serves until it is refused.
    if (peer_.signIn == SignIn::device && !secrets_.token.empty()) {
        token_ = secrets_.token;
        tokenEnds_ = Clock::time_point::max();
    }
}

bool WebSignIn::usesTokenService() const {
    return peer_.signIn == SignIn::clientCredentials || peer_.signIn == SignIn::device;
}

Result<Credentials> WebSignIn::credentials(Progress& progress) {
    switch (peer_.signIn) {
        case SignIn::none:
            return Credentials{};
        case SignIn::basic:
            return Credentials{.user = peer_.user, .password = secrets_.password, .token = {}};
        case SignIn::bearer:
            return Credentials{.user = {}, .password = {}, .token = secrets_.token};
        case SignIn::clientCredentials:
        case SignIn::device:
            break;
    }
    const std::lock_guard guard(mutex_);
    if (token_.empty() || Clock::now() >= tokenEnds_) MACULA_TRY_VOID(getToken(progress));
    return Credentials{.user = {}, .password = {}, .token = token_};
}

bool WebSignIn::renew(const Credentials& refused) {
    if (!usesTokenService()) return false;
    const std::lock_guard guard(mutex_);
    if (token_ == refused.token) token_.clear();
    return true;
}

Result<void> WebSignIn::refresh(Progress& progress) {
    std::chrono::seconds life = kLifeUnknown;
    const AskForTokens ask = [&](const Secrets& had) -> Result<Secrets> {
        if (had.refreshToken.empty()) return signInAgain();
        const std::string form = "grant_type=refresh_token&refresh_token=" + percentEncoded(had.refreshToken);
        MACULA_TRY(TokenAnswer answer, askForToken(tokenSettings_, peer_.tokenUrl, form,
                                                   {peer_.clientId, had.password}, progress));
        if (answer.fault == "invalid_grant") return signInAgain();
        if (!answer.fault.empty()) return noTokenError();
        Secrets renewed = had;
        renewed.token = std::move(answer.accessToken);
        if (!answer.refreshToken.empty()) renewed.refreshToken = std::move(answer.refreshToken);
        life = answer.life;
        return renewed;
    };
    MACULA_TRY(secrets_, renew_ ? renew_(secrets_, ask, progress.token()) : ask(secrets_));
    use(secrets_.token, life);
    return {};
}

void WebSignIn::use(const std::string& token, std::chrono::seconds life) {
    token_ = token;
    tokenEnds_ = Clock::now() + std::max<std::chrono::seconds>(life - kSpareOfToken, life / 2);
}

Result<void> WebSignIn::getToken(Progress& progress) {
    if (peer_.signIn == SignIn::device) return refresh(progress);
    std::string form = "grant_type=client_credentials";
    if (!peer_.scope.empty()) form += "&scope=" + percentEncoded(peer_.scope);
    MACULA_TRY(const TokenAnswer answer, askForToken(tokenSettings_, peer_.tokenUrl, form,
                                                     {peer_.clientId, secrets_.password}, progress));
    if (!answer.fault.empty()) return noTokenError();
    use(answer.accessToken, answer.life);
    return {};
}

}  // namespace macula::net
