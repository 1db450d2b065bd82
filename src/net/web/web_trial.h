// Tries an archive of the web step by step, so that a person sees which of them fails.
#pragma once

#include <string>
#include <vector>

#include "net/archive/archive.h"
#include "net/web/http_client.h"

namespace macula::net {

class WebTrial {
  public:
    // All of them must outlive it.
    WebTrial(const std::string& service, const HttpSettings& settings, CredentialSource& signIn,
             Progress& progress);

    void run();
    void fail(const Error& error);  // the step that is being tried
    std::vector<TestStep> steps() const { return steps_; }

  private:
    enum class Step { address, name, connection, encryption, signIn, search, retrieval };

    static Step stepOf(const HttpOutcome& outcome);
    static Text nameOf(Step step);
    void pass(Step step, Text detail);
    void failAt(Step step, const Error& error);
    // Passes the steps before the one that failed.
    void failAt(const HttpOutcome& outcome);
    void passConnection(const HttpOutcome& outcome);
    void tryRetrieval(HttpClient& client, const std::string& studyInstanceUid);

    const std::string& service_;
    const HttpSettings& settings_;
    CredentialSource& signIn_;
    Progress& progress_;
    bool isSecure_ = false;
    Step now_ = Step::address;
    std::vector<TestStep> steps_;
};

}  // namespace macula::net
