// A request over HTTP, what becomes of its answer, and how it ended.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/source.h"
#include "net/web/http_trouble.h"

namespace macula::net {

struct HttpHead {
    int status = 0;
    std::string contentType;
};

// Takes the body of an answer piece by piece as it arrives. An error of either function ends the exchange.
class HttpSink {
  public:
    virtual ~HttpSink() = default;
    // Called once before the body of an answer that is a success. Answers that are none are not shown.
    virtual Result<void> begin(const HttpHead& head) = 0;
    virtual Result<void> write(std::span<const std::byte> bytes) = 0;
    // Whether its error ends the other requests too.
    virtual bool endsAll() const { return true; }
};

// Gives the body of a request piece by piece.
class HttpBody {
  public:
    virtual ~HttpBody() = default;
    virtual std::uint64_t size() const = 0;
    // Fills the beginning of `bytes`, and returns how many it filled; 0 at the end.
    virtual Result<std::size_t> read(std::span<std::byte> bytes) = 0;
    // The next read begins at the beginning, because the request is made again.
    virtual Result<void> rewind() = 0;
};

// One of both is empty.
struct Credentials {
    std::string user;
    std::string password;
    std::string token;  // bearer

    bool operator==(const Credentials&) const = default;
};

// Where a client takes credentials from. Safe to use from several threads.
class CredentialSource {
  public:
    virtual ~CredentialSource() = default;
    virtual Result<Credentials> credentials(Progress& progress) = 0;
    // The archive did not accept `refused`. Whether others may be had.
    virtual bool renew(const Credentials& refused) = 0;
};

struct HttpRequest {
    std::string url;  // may name a patient: never shown or logged
    std::string accept;
    std::string contentType;       // of the body
    HttpBody* body = nullptr;      // with one it is a POST, else a GET
    HttpSink* sink = nullptr;      // without one the body is thrown away
    std::uintmax_t mostBytes = 0;  // of the answer's body; 0: the sink knows when to stop
    int otherSuccess = 0;          // a status besides 2xx whose body is shown to the sink
};

struct HttpOutcome {
    HttpTrouble trouble = HttpTrouble::none;
    int status = 0;              // 0: no answer
    std::optional<Error> ended;  // an error of the sink or the body, or cancelled
    bool hasWarning = false;     // the answer has a Warning of 299: it is not all that there is
    bool isConnected = false;    // the request could be sent: name, port, proxy and TLS are well
    std::string peer;            // the numeric address of the host or the proxy, where one was reached

    bool ok() const { return trouble == HttpTrouble::none && !ended; }
    Error error() const;  // of an outcome that is not ok
};

struct HttpSettings {
    Tls tls;
    std::string keyPassphrase;
    std::string proxy;
    std::chrono::milliseconds connectTimeout{10000};
    std::chrono::milliseconds answerTimeout{60000};
};

}  // namespace macula::net
