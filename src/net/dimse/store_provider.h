// Takes instances that others send to this program (C-STORE), while somebody wants it to.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "net/archive/reception.h"
#include "net/archive/source.h"

namespace macula::net {

// A connection that was not accepted.
struct TurnedAway {
    enum class Why {
        address,       // not among those that may call
        callingTitle,  // the same
        calledTitle,   // not ours
        tooMany,       // associations at once
        tooOften,
        protection,  // no TLS, or no certificate that is trusted
        noRequest,   // no association was asked for as DICOM says, or nothing that is offered
    };
    Why why{};
    Caller caller;
};
// "CT2 at 10.0.0.7 may not send to this program."
Text textOf(const TurnedAway& turnedAway);

struct StoreProviderOptions {
    std::string ownAe = "MACULA";
    std::uint16_t port = 11112;  // 0: any that is free
    // To listen at; empty: all addresses of this machine. Beyond loopback, `callers` says who may call, or
    // `admitsAnyone` that everybody may.
    std::string address = "127.0.0.1";
    std::vector<AdmittedCaller> callers;  // none: whoever calls from this machine
    bool admitsAnyone = false;
    // Where TLS is on, it holds our certificate and its key. With `authorities`, callers must show one too.
    Tls tls;
    std::string keyPassphrase;

    AdmissionLimits admission;
    std::uintmax_t mostBytesOfInstance = std::uintmax_t{8} << 30;
    std::uintmax_t mostBytes = std::numeric_limits<std::uintmax_t>::max();  // that are kept, in all
    std::chrono::milliseconds idleTimeout{60000};                           // without a byte from the caller

    // Told by the threads that serve.
    std::function<void(const TurnedAway&)> onTurnedAway;
};

// Fails with usage where they cannot work, whatever the files of TLS hold and whoever has the port.
Result<void> checkProviderOptions(const StoreProviderOptions& options);

class StoreProvider {
  public:
    // Listens until it goes, and answers C-ECHO and C-STORE: of every storage class, in every transfer syntax
    // that Macula reads. Instances go to `reception`, which outlives this, as they come: none is ever held
    // whole. Each answer says whether its instance was kept; what comes after an error is tried all the same.
    // Fails with usage where the options cannot work, and with archiveNotUsable where a certificate cannot be
    // read.
    static Result<std::unique_ptr<StoreProvider>> start(const StoreProviderOptions& options,
                                                        Reception& reception);
    ~StoreProvider();

    // Listens no more, and ends what is under way, within a second of its next byte. So does the destructor.
    void end();

    struct Counts {
        std::size_t associations = 0;
        std::size_t turnedAway = 0;
        std::size_t kept = 0;
        std::size_t hadAlready = 0;
        std::size_t refused = 0;      // by the reception, too large, or without a valid name
        std::size_t withoutRoom = 0;  // not kept, because the disk or a limit was full, or of another error
        std::size_t cutOff = 0;       // their connection ended before they were whole
        std::uintmax_t bytes = 0;     // of those kept
    };
    Counts counts() const;
    std::uint16_t port() const;

  private:
    struct State;
    explicit StoreProvider(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace macula::net
