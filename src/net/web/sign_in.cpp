#include "net/web/sign_in.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/exceptions.h"
#include "net/web/gathered_body.h"
#include "net/web/http_client.h"
#include "net/web/web_address.h"

namespace macula::net {

namespace {

constexpr std::uintmax_t kMostBytesOfToken = 64 << 10;
constexpr std::size_t kLongestToken = 16 << 10;
// A token may last shorter than it says: it is asked for again a little before its end.
constexpr std::chrono::seconds kSpareOfToken{30};
constexpr std::chrono::seconds kUsualLifeOfToken{300};  // where the service does not say it
constexpr long kLongestLifeOfToken = 24 * 3600;

struct AccessToken {
    std::string text;
    std::chrono::seconds life{kUsualLifeOfToken};
};

Error noTokenError() {
    return {ErrorCode::archiveNotUsable,
            Text("The service that gives tokens for the archive did not give one."),
            {},
            Text("Check its address, the client, its secret and the scope in the settings of the archive.")};
}

// Of RFC 6749 5.1.
Result<AccessToken> tokenIn(const std::string& answer) {
    try {
        const auto flat = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
            return depth < 8;  // what is deeper is left out
        };
        const auto json = nlohmann::json::parse(answer, flat, false);
        if (!json.is_object() || !json.contains("access_token")) return noTokenError();
        AccessToken token;
        token.text = json["access_token"].get<std::string>();
        const auto isPlain = [](char c) { return c > ' ' && c < '\x7f'; };
        if (token.text.empty() || token.text.size() > kLongestToken ||
            !std::ranges::all_of(token.text, isPlain))
            return noTokenError();
        if (json.contains("expires_in") && json["expires_in"].is_number())
            token.life = std::chrono::seconds(static_cast<long>(
                std::clamp(json["expires_in"].get<double>(), 1.0, double{kLongestLifeOfToken})));
        return token;
    } catch (const nlohmann::json::exception&) {
        return noTokenError();
    } catch (const std::exception& thrown) {
        return errorOf(thrown, Text("sign in"));
    }
}

// The credentials of the client, for one request.
class ClientCredentials final : public CredentialSource {
  public:
    explicit ClientCredentials(Credentials own) : own_(std::move(own)) {}
    Result<Credentials> credentials(Progress& /*progress*/) override { return own_; }
    bool renew(const Credentials& /*refused*/) override { return false; }

  private:
    Credentials own_;
};

}  // namespace

WebSignIn::WebSignIn(const WebPeer& peer, const Secrets& secrets, const HttpSettings& settings)
    : peer_(peer), secrets_(secrets), tokenSettings_(settings) {
    tokenSettings_.tls.certificate.clear();
    tokenSettings_.tls.key.clear();
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
            break;
    }
    const std::lock_guard guard(mutex_);
    if (token_.empty() || std::chrono::steady_clock::now() >= tokenEnds_) {
        MACULA_TRY(token_, newToken(progress));
    }
    return Credentials{.user = {}, .password = {}, .token = token_};
}

bool WebSignIn::renew(const Credentials& refused) {
    if (peer_.signIn != SignIn::clientCredentials) return false;
    const std::lock_guard guard(mutex_);
    if (token_ == refused.token) token_.clear();
    return true;
}

Result<std::string> WebSignIn::newToken(Progress& progress) {
    std::string form = "grant_type=client_credentials";
    if (!peer_.scope.empty()) form += "&scope=" + percentEncoded(peer_.scope);
    // First as RFC 6749 2.3.1 wants it, then as some services do.
    for (const bool isInBody : {false, true}) {
        TextBody body(isInBody ? form + "&client_id=" + percentEncoded(peer_.clientId) +
                                     "&client_secret=" + percentEncoded(secrets_.password)
                               : form);
        ClientCredentials own({.user = percentEncoded(peer_.clientId),
                               .password = percentEncoded(secrets_.password),
                               .token = {}});
        GatheredBody answer;
        const HttpRequest request{.url = peer_.tokenUrl,
                                  .accept = "application/json",
                                  .contentType = "application/x-www-form-urlencoded",
                                  .body = &body,
                                  .sink = &answer,
                                  .mostBytes = kMostBytesOfToken};
        HttpClient client(tokenSettings_, isInBody ? nullptr : &own);
        const HttpOutcome outcome = client.run(request, progress);
        if (outcome.ok()) {
            MACULA_TRY(AccessToken token, tokenIn(answer.text()));
            tokenEnds_ = std::chrono::steady_clock::now() +
                         std::max<std::chrono::seconds>(token.life - kSpareOfToken, token.life / 2);
            return std::move(token.text);
        }
        if (outcome.ended) return *outcome.ended;
        const bool wasRefused =
            outcome.trouble == HttpTrouble::badRequest || outcome.trouble == HttpTrouble::signInRefused;
        if (!wasRefused) {
            Error error = outcome.error();
            error.message = Text("The service that gives tokens failed: {}", std::move(error.message));
            return error;
        }
    }
    return noTokenError();
}

}  // namespace macula::net
