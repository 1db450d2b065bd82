// A connection over TCP, with TLS where it is asked for, that can be cancelled and waits for nothing longer
// than it is told. DCMTK's own connections are made without a limit that belongs to one of them alone, know
// no IPv6, and hear of no cancelling.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/dimse/heartbeat.h"

namespace macula::net {

class TlsSettings;

// Why nothing more comes or goes.
enum class WireTrouble { none, cancelled, timedOut, closed };

// Where a connection leads, and for how long it is waited for.
struct WireTarget {
    std::string host;
    std::uint16_t port = 0;
    std::chrono::milliseconds connectTimeout{10000};
    std::chrono::milliseconds answerTimeout{60000};
};

// An address of a host, as numbers.
struct WireAddress {
    alignas(8) unsigned char bytes[128] = {};
    unsigned length = 0;
    int family = 0;
};
Result<std::vector<WireAddress>> addressesOf(const WireTarget& target, const CancelToken& cancel);

class Wire {
  public:
    using Clock = std::chrono::steady_clock;

    // Tries the addresses in turn.
    static Result<std::unique_ptr<Wire>> connect(const WireTarget& target,
                                                 const std::vector<WireAddress>& addresses,
                                                 const CancelToken& cancel);
    // Of a connection that was accepted, which it owns.
    Wire(int socket, std::chrono::milliseconds answerTimeout, CancelToken cancel);
    ~Wire();
    Wire(const Wire&) = delete;
    Wire& operator=(const Wire&) = delete;

    // Errors name what is wrong: an expired certificate, one for another host, a peer without TLS.
    Result<void> beginTls(const TlsSettings& settings, const std::string& host,
                          std::chrono::milliseconds patience);

    // Waits for bytes, and returns how many it read: at least one, or 0 after trouble.
    std::size_t read(void* bytes, std::size_t most);
    // All of them, or false.
    bool write(const void* bytes, std::size_t count);
    // Waits for the first byte of what comes next.
    WireTrouble wait();
    // The same, where nothing else can be done once it is cancelled.
    bool waitToTheEnd();

    WireTrouble trouble() const { return trouble_; }
    // From now on nothing is cancelled any more; what is not done by then fails.
    void finishWithin(std::chrono::milliseconds patience);
    bool isFinishing() const { return finish_.has_value(); }
    // All waiting ends then, however much comes until then; nothing: each byte gives the peer more time.
    void setEnd(std::optional<Clock::time_point> end) { end_ = end; }
    // What comes over one of the wires that share it counts as an answer for all.
    void setHeartbeat(std::shared_ptr<Heartbeat> heartbeat) { heartbeat_ = std::move(heartbeat); }

  private:
    struct Tls;

    bool awaits(short events, Clock::time_point until);
    Clock::time_point deadline() const;
    std::size_t fail(WireTrouble trouble);
    std::size_t came(std::size_t count);
    std::size_t readPlain(void* bytes, std::size_t most);
    std::size_t readTls(void* bytes, std::size_t most);
    bool awaitsTls(int result, Clock::time_point until);

    int socket_;
    std::chrono::milliseconds answerTimeout_;
    CancelToken cancel_;
    std::optional<Clock::time_point> finish_;
    std::optional<Clock::time_point> end_;
    WireTrouble trouble_ = WireTrouble::none;
    std::unique_ptr<Tls> tls_;
    std::shared_ptr<Heartbeat> heartbeat_;
};

}  // namespace macula::net
