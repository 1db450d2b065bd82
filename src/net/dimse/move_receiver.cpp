#include "net/dimse/move_receiver.h"

#include <chrono>
#include <utility>

#include "net/dimse/acceptor.h"
#include "net/dimse/contexts.h"
#include "net/dimse/port_turn.h"
#include "net/dimse/requests.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::net {

namespace {

constexpr std::size_t kMostAssociations = 8;

}  // namespace

const std::string& receiverTitle(const DimsePeer& peer) {
    return peer.receiverAe.empty() ? peer.callingAe : peer.receiverAe;
}

struct MoveReceiver::State {
    State(Incoming& theIncoming, std::uint16_t port) : incoming(theIncoming), turn(port) {}

    void serve(const Acceptor::Connection& connection);
    bool receive(Association& association, const ReceivedCommand& request);

    Incoming& incoming;
    PortTurn turn;
    std::string title;
    Encodings encodings = Encodings::any;
    std::chrono::milliseconds answerTimeout{};
    std::shared_ptr<const TlsSettings> tls;
    std::shared_ptr<Heartbeat> heartbeat;
    CancelToken stop;  // its own: what is under way is ended too
    std::unique_ptr<Acceptor> acceptor;
};

bool MoveReceiver::State::receive(Association& association, const ReceivedCommand& request) {
    if (request.command.field != CommandField::storeRequest) return false;
    // Bytes of anybody at all are no sign that the archive lives, but those of an instance are: a large
    // one takes longer than an answer may.
    association.wire().setHeartbeat(heartbeat);
    const bool isStored = incoming.store(association, request).ok();
    association.wire().setHeartbeat(nullptr);
    return isStored;
}

void MoveReceiver::State::serve(const Acceptor::Connection& connection) {
    const QuietToolkit quiet;
    auto wire = std::make_unique<Wire>(connection.socket, answerTimeout, stop);
    if (tls && !wire->beginTls(*tls, {}, answerTimeout)) return;
    const Welcome welcome{
        .judge = [this](const AssociationTitles& titles) { return unlessCalled(titles, title); },
        .offers = isStorageClass,
        .takes = [this](std::string_view uid) { return isAmong(encodings, uid); }};
    const Result<std::unique_ptr<Association>> association = Association::accept(std::move(wire), welcome);
    if (!association) return;
    answerRequests(**association, [this, &association](const ReceivedCommand& request) {
        return receive(**association, request);
    });
}

MoveReceiver::MoveReceiver(std::unique_ptr<State> state) : state_(std::move(state)) {}

MoveReceiver::~MoveReceiver() = default;

std::size_t MoveReceiver::openAssociations() const {
    return state_->acceptor->open();
}

Result<std::unique_ptr<MoveReceiver>> MoveReceiver::start(const Connector& connector, Incoming& incoming,
                                                          std::shared_ptr<Heartbeat> heartbeat,
                                                          Encodings encodings, const CancelToken& cancel) {
    const DimsePeer& peer = connector.peer();
    auto state = std::make_unique<State>(incoming, peer.receiverPort);
    if (!state->turn.wait(cancel)) return cancelledError();
    state->title = receiverTitle(peer);
    state->encodings = encodings;
    state->answerTimeout = connector.answerTimeout();
    state->heartbeat = std::move(heartbeat);
    MACULA_TRY(state->tls, connector.receiverTls());
    MACULA_TRY(state->acceptor,
               Acceptor::start({peer.receiverAddress, peer.receiverPort}, kMostAssociations, state->stop,
                               [shared = state.get()](const Acceptor::Connection& connection) {
                                   shared->serve(connection);
                               }));
    return std::unique_ptr<MoveReceiver>(new MoveReceiver(std::move(state)));
}

}  // namespace macula::net
