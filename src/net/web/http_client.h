// Requests over HTTP, several at once over connections that are used again.
#pragma once

#include <curl/curl.h>

#include <memory>
#include <span>
#include <vector>

#include "net/web/http_exchange.h"

namespace macula::net {

// For one thread. Sinks and bodies are called in the thread that runs the requests.
class HttpClient {
  public:
    // Both must outlive the client. Without `signIn` requests go without credentials.
    HttpClient(const HttpSettings& settings, CredentialSource* signIn);
    ~HttpClient();
    HttpClient(const HttpClient&) = delete;
    HttpClient& operator=(const HttpClient&) = delete;

    // Makes all of them, at most `mostAtOnce` at a time, and returns an outcome for each. A busy server gets
    // a second request after the time that it names, and one that does not accept a token a new one. An error
    // of a sink or a body, or cancelling, ends all.
    std::vector<HttpOutcome> run(std::span<const HttpRequest> requests, std::size_t mostAtOnce,
                                 Progress& progress);
    HttpOutcome run(const HttpRequest& request, Progress& progress);

  private:
    const HttpSettings& settings_;
    CredentialSource* signIn_;
    std::unique_ptr<CURLM, CURLMcode (*)(CURLM*)> multi_;
};

}  // namespace macula::net
