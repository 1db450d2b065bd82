#include "net/web/token_service.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "net/web/flat_json.h"
#include "net/web/gathered_body.h"
#include "net/web/http_client.h"
#include "net/web/web_address.h"

namespace macula::net {

namespace {

constexpr std::uintmax_t kMostBytesOfToken = 64 << 10;
constexpr std::size_t kLongestToken = 16 << 10;
constexpr double kLongestLifeOfToken = 24 * 3600;
constexpr int kBadRequest = 400;

bool isToken(const std::string& text) {
    return !text.empty() && text.size() <= kLongestToken &&
           std::ranges::all_of(text, [](char c) { return c > ' ' && c < '\x7f'; });
}

// Of RFC 6749 5.1 and 5.2.
Result<TokenAnswer> tokenIn(const std::string& text) {
    const nlohmann::json json = flatJson(text);
    TokenAnswer answer;
    answer.fault = textIn(json, "error");
    if (!answer.fault.empty()) return answer;
    answer.accessToken = textIn(json, "access_token");
    answer.refreshToken = textIn(json, "refresh_token");
    if (!isToken(answer.accessToken) || (!answer.refreshToken.empty() && !isToken(answer.refreshToken)))
        return noTokenError();
    if (const auto life = numberIn(json, "expires_in"))
        answer.life = std::chrono::seconds(static_cast<long>(std::clamp(*life, 1.0, kLongestLifeOfToken)));
    return answer;
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

bool mayTryOtherwise(const HttpOutcome& outcome, const Result<TokenAnswer>& answer) {
    return outcome.trouble == HttpTrouble::signInRefused || !answer || answer->fault == "invalid_client" ||
           answer->fault == "invalid_request";
}

}  // namespace

Error noTokenError() {
    return {ErrorCode::archiveNotUsable,
            Text("The service that gives tokens for the archive did not give one."),
            {},
            Text("Check its address, the client, its secret and the scope in the settings of the archive.")};
}

HttpSettings withoutOwnCertificate(HttpSettings settings) {
    settings.tls.certificate.clear();
    settings.tls.key.clear();
    return settings;
}

FormAnswer sendForm(const HttpSettings& settings, const std::string& url, const std::string& form,
                    CredentialSource* credentials, Progress& progress) {
    TextBody body(form);
    GatheredBody answer;
    const HttpRequest request{.url = url,
                              .accept = "application/json",
                              .contentType = "application/x-www-form-urlencoded",
                              .body = &body,
                              .sink = &answer,
                              .mostBytes = kMostBytesOfToken,
                              .otherSuccess = kBadRequest};
    HttpClient client(settings, credentials);
    HttpOutcome outcome = client.run(request, progress);
    return {std::move(outcome), answer.text()};
}

Result<TokenAnswer> askForToken(const HttpSettings& settings, const std::string& url, const std::string& form,
                                const TokenClient& client, Progress& progress) {
    for (const bool isInBody : {false, true}) {
        if (!isInBody && client.secret.empty()) continue;  // a public client has no password
        std::string whole = form;
        if (isInBody) whole += "&client_id=" + percentEncoded(client.id);
        if (isInBody && !client.secret.empty()) whole += "&client_secret=" + percentEncoded(client.secret);
        ClientCredentials own(
            {.user = percentEncoded(client.id), .password = percentEncoded(client.secret), .token = {}});
        const FormAnswer sent = sendForm(settings, url, whole, isInBody ? nullptr : &own, progress);
        if (sent.outcome.ended) return *sent.outcome.ended;
        const bool wasAnswered = sent.outcome.ok() || sent.outcome.status == kBadRequest;
        if (!wasAnswered && sent.outcome.trouble != HttpTrouble::signInRefused) {
            Error error = sent.outcome.error();
            error.message = Text("The service that gives tokens failed: {}", std::move(error.message));
            return error;
        }
        Result<TokenAnswer> answer = wasAnswered ? tokenIn(sent.text) : Result<TokenAnswer>(noTokenError());
        if (isInBody || !mayTryOtherwise(sent.outcome, answer)) return answer;
    }
    return noTokenError();
}

}  // namespace macula::net
