#include "net/dimse/store_provider.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "net/dimse/acceptor.h"
#include "net/dimse/admission.h"
#include "net/dimse/contexts.h"
#include "net/dimse/dimse_archive.h"
#include "net/dimse/instance_arrival.h"
#include "net/dimse/requests.h"
#include "net/dimse/tls.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::net {

namespace {

// Connections that are only told why they are turned away.
constexpr std::size_t kSpareConnections = 8;
constexpr std::chrono::milliseconds kPatienceForRequest{10000};
constexpr std::uintmax_t kMostReadOver = std::uintmax_t{1} << 30;
constexpr std::uintmax_t kDiskIsLookedAtEvery = std::uintmax_t{16} << 20;

constexpr Rejection kStranger{.result = 1, .source = 1, .reason = 3};  // calling AE title not recognised

Error badOption(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

std::string nameOf(const Caller& caller) {
    if (caller.address.empty()) return caller.ae;
    return caller.ae.empty() ? caller.address : caller.ae + " (" + caller.address + ")";
}

}  // namespace

Result<void> checkProviderOptions(const StoreProviderOptions& options) {
    if (!isAeTitle(options.ownAe))
        return badOption(Text("The AE title of this program is not valid."),
                         Text("An AE title has 1 to 16 letters, digits and signs, without accents."));
    if (options.callers.empty() && !options.admitsAnyone && !isOfThisMachineAlone(options.address))
        return badOption(Text("Other machines could send to this program, and nobody said which may."),
                         Text("Name those that may send, or say that anyone may."));
    if (options.tls.isOn && options.tls.certificate.empty())
        return badOption(Text("To protect connections that others make, this program needs a certificate."),
                         Text("Enter a certificate with its key."));
    MACULA_TRY([[maybe_unused]] const auto admission,
               Admission::of(options.callers, options.admitsAnyone, options.admission));
    return {};
}

Text textOf(const TurnedAway& turnedAway) {
    const std::string name = nameOf(turnedAway.caller);
    switch (turnedAway.why) {
        case TurnedAway::Why::address:
        case TurnedAway::Why::callingTitle:
            return Text("{} wanted to send, and is not among those that may.", name);
        case TurnedAway::Why::calledTitle:
            return Text("{} called this program by another AE title.", name);
        case TurnedAway::Why::tooMany:
            return Text("{} was turned away, because as many connections are open as this program allows.",
                        name);
        case TurnedAway::Why::tooOften:
            return Text("{} was turned away, because more connections came than this program allows.", name);
        case TurnedAway::Why::protection:
            return Text("{} made no protected connection, or showed no certificate that is trusted.", name);
        case TurnedAway::Why::noRequest:
            return Text("{} did not ask to send images as DICOM prescribes.", name);
    }
    return {};
}

struct StoreProvider::State {
    State(StoreProviderOptions theOptions, Reception& theReception)
        : options(std::move(theOptions)), reception(theReception) {}

    void serve(const Acceptor::Connection& connection);
    void serveAdmitted(std::unique_ptr<Wire> wire, const WireAddress& from);
    bool store(Association& association, const ReceivedCommand& request, Receiver& receiver);
    std::uint16_t take(const ArrivedInstance& arrived, const Command& command, Receiver& receiver,
                       std::uintmax_t bytes);
    bool reserve(std::uintmax_t bytes);
    void giveBack(std::uintmax_t bytes);
    void turnAway(TurnedAway::Why why, const Caller& caller);
    void count(std::size_t Counts::*which);

    const StoreProviderOptions options;
    Reception& reception;
    std::shared_ptr<const TlsSettings> tls;
    std::unique_ptr<Admission> admission;
    mutable std::mutex mutex;
    Counts counts;
    std::uintmax_t reserved = 0;  // of mostBytes: by what was kept, and by what is on its way
    CancelToken stop;
    std::uint16_t port = 0;
    std::unique_ptr<Acceptor> acceptor;
};

void StoreProvider::State::count(std::size_t Counts::*which) {
    const std::lock_guard lock(mutex);
    ++(counts.*which);
}

void StoreProvider::State::turnAway(TurnedAway::Why why, const Caller& caller) {
    count(&Counts::turnedAway);
    if (options.onTurnedAway) options.onTurnedAway({why, caller});
}

bool StoreProvider::State::reserve(std::uintmax_t bytes) {
    const std::lock_guard lock(mutex);
    if (bytes > options.mostBytes - reserved) return false;
    reserved += bytes;
    return true;
}

void StoreProvider::State::giveBack(std::uintmax_t bytes) {
    const std::lock_guard lock(mutex);
    reserved -= bytes;
}

void StoreProvider::State::serve(const Acceptor::Connection& connection) {
    const QuietToolkit quiet;
    const Caller caller{.ae = {}, .address = textOf(connection.from)};
    auto wire = std::make_unique<Wire>(connection.socket, options.idleTimeout, stop);
    if (!admission->mayConnect(connection.from)) {
        turnAway(TurnedAway::Why::address, caller);
        // Of strangers, nothing is read into the parsers of DICOM or TLS.
        if (!tls) rejectUnread(*wire, kStranger);
        return;
    }
    const std::optional<Rejection> rejection = admission->enter(Admission::Clock::now());
    if (tls && !wire->beginTls(*tls, {}, std::min(options.idleTimeout, kPatienceForRequest))) {
        if (!rejection) admission->leave();
        return turnAway(TurnedAway::Why::protection, caller);
    }
    if (rejection) {
        turnAway(rejection->reason == 2 ? TurnedAway::Why::tooMany : TurnedAway::Why::tooOften, caller);
        return rejectUnread(*wire, *rejection);
    }
    serveAdmitted(std::move(wire), connection.from);
    admission->leave();
}

void StoreProvider::State::serveAdmitted(std::unique_ptr<Wire> wire, const WireAddress& from) {
    Caller caller{.ae = {}, .address = textOf(from)};
    TurnedAway::Why why = TurnedAway::Why::noRequest;
    const Welcome welcome{.judge = [&](const AssociationTitles& titles) -> std::optional<Rejection> {
                              caller.ae = titles.callingAe;
                              std::optional<Rejection> rejection = unlessCalled(titles, options.ownAe);
                              if (rejection) why = TurnedAway::Why::calledTitle;
                              if (!rejection && !admission->mayCall(titles.callingAe, from)) {
                                  why = TurnedAway::Why::callingTitle;
                                  rejection = kStranger;
                              }
                              return rejection;
                          },
                          .offers = isStorageClass,
                          .patience = std::min(options.idleTimeout, kPatienceForRequest)};
    const Result<std::unique_ptr<Association>> association = Association::accept(std::move(wire), welcome);
    if (!association) return turnAway(why, caller);
    count(&Counts::associations);
    const std::unique_ptr<Receiver> receiver = reception.receiverFor(caller);
    answerRequests(**association,
                   [&](const ReceivedCommand& request) { return store(**association, request, *receiver); });
}

bool StoreProvider::State::store(Association& association, const ReceivedCommand& request,
                                 Receiver& receiver) {
    using Fate = ArrivedInstance::Fate;
    const Command& command = request.command;
    if (command.field != CommandField::storeRequest || !command.messageId || !command.hasDataset)
        return false;
    std::uintmax_t bytes = 0;
    std::uintmax_t lookedAt = 0;
    const ArrivalLimits limits{
        .mostBytes = std::min(options.mostBytesOfInstance, receiver.mostBytesOfInstance()),
        .hasRoomFor =
            [&](std::size_t more) {
                // Several that come at once must not fill the disk together.
                if (bytes >= lookedAt + kDiskIsLookedAtEvery) {
                    if (receiver.mostBytesOfInstance() == 0) return false;
                    lookedAt = bytes;
                }
                if (!reserve(more)) return false;
                bytes += more;
                return true;
            },
        .mostReadOver = kMostReadOver};
    const ArrivedInstance arrived = receiveInstance(association, request, receiver, limits);
    std::uint16_t status = kStatusNotWanted;
    switch (arrived.fate) {
        case Fate::whole:
            status = take(arrived, command, receiver, bytes);
            break;
        case Fate::nameless:
        case Fate::tooLarge:
            count(&Counts::refused);
            break;
        case Fate::withoutRoom:
            count(&Counts::withoutRoom);
            status = kStatusNoRoom;
            break;
        case Fate::cutOff:
            count(&Counts::cutOff);
            break;
    }
    if (arrived.fate != Fate::whole) giveBack(bytes);
    if (!arrived.isReadToTheEnd) return false;
    const Command response{.field = CommandField::storeResponse,
                           .respondsTo = command.messageId,
                           .sopClassUid = command.sopClassUid,
                           .sopInstanceUid = command.sopInstanceUid,
                           .status = status};
    return sendCommand(association, request.context, response).ok();
}

std::uint16_t StoreProvider::State::take(const ArrivedInstance& arrived, const Command& command,
                                         Receiver& receiver, std::uintmax_t bytes) {
    const Result<Receiver::Verdict> verdict = receiver.take(
        arrived.file, {arrived.studyInstanceUid, {}, command.sopClassUid, command.sopInstanceUid});
    if (!verdict || *verdict != Receiver::Verdict::kept) giveBack(bytes);
    if (!verdict) {
        count(&Counts::withoutRoom);
        return kStatusNoRoom;
    }
    switch (*verdict) {
        case Receiver::Verdict::kept: {
            const std::lock_guard lock(mutex);
            ++counts.kept;
            counts.bytes += bytes;
            return kStatusStored;
        }
        case Receiver::Verdict::hadAlready:
            count(&Counts::hadAlready);
            return kStatusStored;
        case Receiver::Verdict::refused:
            break;
    }
    count(&Counts::refused);
    return kStatusNotWanted;
}

StoreProvider::StoreProvider(std::unique_ptr<State> state) : state_(std::move(state)) {}

StoreProvider::~StoreProvider() = default;

void StoreProvider::end() {
    state_->acceptor.reset();
}

StoreProvider::Counts StoreProvider::counts() const {
    const std::lock_guard lock(state_->mutex);
    return state_->counts;
}

std::uint16_t StoreProvider::port() const {
    return state_->port;
}

Result<std::unique_ptr<StoreProvider>> StoreProvider::start(const StoreProviderOptions& options,
                                                            Reception& reception) {
    MACULA_TRY_VOID(checkProviderOptions(options));
    auto state = std::make_unique<State>(options, reception);
    MACULA_TRY(state->admission, Admission::of(options.callers, options.admitsAnyone, options.admission));
    if (options.tls.isOn) {
        const auto role =
            options.tls.authorities.empty() ? TlsSettings::Role::acceptsAnyone : TlsSettings::Role::accepts;
        MACULA_TRY(state->tls, TlsSettings::of(options.tls, options.keyPassphrase, role));
    }
    MACULA_TRY(
        state->acceptor,
        Acceptor::start(
            {options.address, options.port}, options.admission.associations + kSpareConnections, state->stop,
            [shared = state.get()](const Acceptor::Connection& connection) { shared->serve(connection); }));
    state->port = state->acceptor->port();
    return std::unique_ptr<StoreProvider>(new StoreProvider(std::move(state)));
}

}  // namespace macula::net
