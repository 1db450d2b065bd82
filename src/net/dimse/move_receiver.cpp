#include "net/dimse/move_receiver.h"

#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <list>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "net/dimse/messages.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::net {

namespace {

constexpr std::size_t kMostAssociations = 8;
constexpr std::chrono::milliseconds kAcceptSlice{50};

// One mutex for each port of this machine that anybody in this process listens at.
std::shared_ptr<std::timed_mutex> mutexOfPort(std::uint16_t port) {
    static std::mutex mutex;
    static std::map<std::uint16_t, std::shared_ptr<std::timed_mutex>> mutexes;
    const std::lock_guard lock(mutex);
    auto& found = mutexes[port];
    if (!found) found = std::make_shared<std::timed_mutex>();
    return found;
}

int listenerAt(const addrinfo& address) {
    const int listener = ::socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (listener < 0) return -1;
    const int isOn = 1;
    const int isOff = 0;
    setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &isOn, sizeof isOn);
    if (address.ai_family == AF_INET6) setsockopt(listener, IPPROTO_IPV6, IPV6_V6ONLY, &isOff, sizeof isOff);
    if (bind(listener, address.ai_addr, address.ai_addrlen) == 0 &&
        listen(listener, static_cast<int>(kMostAssociations)) == 0)
        return listener;
    const int problem = errno;
    ::close(listener);
    errno = problem;
    return -1;
}

Result<int> listenAt(const std::string& host, std::uint16_t port) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* list = nullptr;
    const bool isFound =
        getaddrinfo(host.empty() ? nullptr : host.c_str(), std::to_string(port).c_str(), &hints, &list) == 0;
    int listener = -1;
    errno = EADDRNOTAVAIL;
    // Those of IPv6 take connections of IPv4 too.
    for (const int family : {AF_INET6, AF_INET}) {
        for (const addrinfo* each = list; isFound && each != nullptr && listener < 0; each = each->ai_next)
            if (each->ai_family == family) listener = listenerAt(*each);
    }
    const int problem = errno;
    if (isFound) freeaddrinfo(list);
    if (listener >= 0) return listener;
    if (problem == EADDRINUSE)
        return Error{ErrorCode::usage,
                     Text("Another program already listens at port {}, where the archive is to send.", port),
                     {},
                     Text("End that program, or choose another port here and in the archive.")};
    if (problem == EACCES)
        return Error{ErrorCode::usage,
                     Text("This program may not listen at port {}, where the archive is to send.", port),
                     {},
                     Text("Choose a port above 1023, here and in the archive.")};
    return Error{ErrorCode::usage,
                 Text("This machine has no such address to listen at for what the archive sends."),
                 {},
                 Text("Leave the receiver's address empty, or enter one of this machine.")};
}

void answerEcho(Association& association, const ReceivedCommand& request) {
    const Command response{.field = CommandField::echoResponse,
                           .respondsTo = request.command.messageId,
                           .sopClassUid = request.command.sopClassUid,
                           .status = std::uint16_t{0}};
    static_cast<void>(sendCommand(association, request.context, response));
}

}  // namespace

const std::string& receiverTitle(const DimsePeer& peer) {
    return peer.receiverAe.empty() ? peer.callingAe : peer.receiverAe;
}

struct MoveReceiver::State {
    State(Incoming& theIncoming, std::shared_ptr<std::timed_mutex> mutex)
        : incoming(theIncoming), portMutex(std::move(mutex)), portLock(*portMutex, std::defer_lock) {}

    void acceptAll();
    void serve(int socket);
    void receiveAll(Association& association);

    Incoming& incoming;
    std::shared_ptr<std::timed_mutex> portMutex;
    std::unique_lock<std::timed_mutex> portLock;
    std::string title;
    std::chrono::milliseconds answerTimeout{};
    std::shared_ptr<const TlsSettings> tls;
    std::shared_ptr<Heartbeat> heartbeat;
    CancelToken stop;  // its own: what is under way is ended too
    int listener = -1;
    std::atomic<std::size_t> open{0};
    // One for each association. Of the accepting thread alone, until that has ended.
    struct Server {
        std::atomic<bool> isDone{false};
        std::thread thread;
    };
    void joinServers(bool onlyDone);
    std::list<Server> servers;
    std::thread acceptor;
};

void MoveReceiver::State::joinServers(bool onlyDone) {
    for (auto server = servers.begin(); server != servers.end();) {
        if (onlyDone && !server->isDone.load()) {
            ++server;
            continue;
        }
        if (server->thread.joinable()) server->thread.join();
        server = servers.erase(server);
    }
}

void MoveReceiver::State::receiveAll(Association& association) {
    while (true) {
        const Result<ReceivedCommand> request = receiveCommand(association);
        if (!request) return;
        if (request->command.field == CommandField::echoRequest) {
            answerEcho(association, *request);
            continue;
        }
        if (request->command.field != CommandField::storeRequest) return;
        // Bytes of anybody at all are no sign that the archive lives, but those of an instance are: a large
        // one takes longer than an answer may.
        association.wire().setHeartbeat(heartbeat);
        if (!incoming.store(association, *request)) return;
        association.wire().setHeartbeat(nullptr);
    }
}

void MoveReceiver::State::serve(int socket) {
    const QuietToolkit quiet;
    auto wire = std::make_unique<Wire>(socket, answerTimeout, stop);
    if (!tls || wire->beginTls(*tls, {}, answerTimeout)) {
        const Result<std::unique_ptr<Association>> association = Association::accept(std::move(wire), title);
        if (association) receiveAll(**association);
    }
    --open;
}

void MoveReceiver::State::acceptAll() {
    while (!stop.cancelled()) {
        pollfd watched{listener, POLLIN, 0};
        const int ready = poll(&watched, 1, static_cast<int>(kAcceptSlice.count()));
        joinServers(true);
        if (ready <= 0) continue;
        const int socket = accept4(listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (socket < 0) continue;
        if (open.load() >= kMostAssociations) {
            ::close(socket);
            continue;
        }
        ++open;
        Server& server = servers.emplace_back();
        try {
            server.thread = std::thread([this, socket, &server] {
                serve(socket);
                server.isDone = true;
            });
        } catch (const std::system_error&) {  // there are no more threads
            ::close(socket);
            --open;
            servers.pop_back();
        }
    }
}

MoveReceiver::MoveReceiver(std::unique_ptr<State> state) : state_(std::move(state)) {}

MoveReceiver::~MoveReceiver() {
    state_->stop.cancel();
    if (state_->acceptor.joinable()) state_->acceptor.join();
    state_->joinServers(false);
    if (state_->listener >= 0) ::close(state_->listener);
}

std::size_t MoveReceiver::openAssociations() const {
    return state_->open.load();
}

Result<std::unique_ptr<MoveReceiver>> MoveReceiver::start(const Connector& connector, Incoming& incoming,
                                                          std::shared_ptr<Heartbeat> heartbeat,
                                                          const CancelToken& cancel) {
    const DimsePeer& peer = connector.peer();
    auto state = std::make_unique<State>(incoming, mutexOfPort(peer.receiverPort));
    while (!state->portLock.try_lock_for(kAcceptSlice))
        if (cancel.cancelled()) return cancelledError();
    state->title = receiverTitle(peer);
    state->answerTimeout = connector.answerTimeout();
    state->heartbeat = std::move(heartbeat);
    MACULA_TRY(state->tls, connector.receiverTls());
    MACULA_TRY(state->listener, listenAt(peer.receiverAddress, peer.receiverPort));
    std::unique_ptr<MoveReceiver> receiver(new MoveReceiver(std::move(state)));
    State* shared = receiver->state_.get();
    try {
        shared->acceptor = std::thread([shared] { shared->acceptAll(); });
    } catch (const std::system_error&) {
        return Error{ErrorCode::outOfMemory,
                     Text("This machine has no means left to receive instances."),
                     {},
                     Text("Close other programs and try again.")};
    }
    return receiver;
}

}  // namespace macula::net
