// A service that gives tokens (OAuth 2, RFC 6749).
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "net/web/http_exchange.h"

namespace macula::net {

struct TokenAnswer {
    std::string accessToken;
    std::string refreshToken;  // empty where the service gives none, or lets the old one be used again
    std::chrono::seconds life{300};
    std::string fault;  // of RFC 6749 5.2, as in invalid_grant; then there are no tokens
};

// How the client shows who it is.
struct TokenClient {
    std::string id;
    std::string secret;  // empty: a public client
};

// Asks with a form that lacks only the client: first as RFC 6749 2.3.1 wants it, then as some services do.
// Fails with archiveNotUsable where the service does not answer as one.
Result<TokenAnswer> askForToken(const HttpSettings& settings, const std::string& url, const std::string& form,
                                const TokenClient& client, Progress& progress);

// A form sent to such a service, and its answer as text: of a success, or of a fault (400).
struct FormAnswer {
    HttpOutcome outcome;
    std::string text;
};
FormAnswer sendForm(const HttpSettings& settings, const std::string& url, const std::string& form,
                    CredentialSource* credentials, Progress& progress);

// Ours at the archive is for the archive alone.
HttpSettings withoutOwnCertificate(HttpSettings settings);

Error noTokenError();

}  // namespace macula::net
