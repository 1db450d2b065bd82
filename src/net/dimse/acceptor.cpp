#include "net/dimse/acceptor.h"

#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

namespace macula::net {

namespace {

constexpr int kBacklog = 16;
constexpr std::chrono::milliseconds kAcceptSlice{50};

Error portInUse(std::uint16_t port) {
    return {ErrorCode::usage,
            Text("Another program already listens at port {}.", port),
            {},
            Text("End that program, or choose another port here and where the images come from.")};
}

int listenerAt(const addrinfo& address) {
    const int listener = ::socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (listener < 0) return -1;
    const int isOn = 1;
    const int isOff = 0;
    setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &isOn, sizeof isOn);
    if (address.ai_family == AF_INET6) setsockopt(listener, IPPROTO_IPV6, IPV6_V6ONLY, &isOff, sizeof isOff);
    if (bind(listener, address.ai_addr, address.ai_addrlen) == 0 && listen(listener, kBacklog) == 0)
        return listener;
    const int problem = errno;
    ::close(listener);
    errno = problem;
    return -1;
}

Result<int> listenAt(const ListeningPlace& place) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* list = nullptr;
    const bool isFound = getaddrinfo(place.address.empty() ? nullptr : place.address.c_str(),
                                     std::to_string(place.port).c_str(), &hints, &list) == 0;
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
    if (problem == EADDRINUSE) return portInUse(place.port);
    if (problem == EACCES)
        return Error{ErrorCode::usage,
                     Text("This program may not listen at port {}.", place.port),
                     {},
                     Text("Choose a port above 1023, here and where the images come from.")};
    return Error{ErrorCode::usage,
                 Text("This machine has no such address to listen at."),
                 {},
                 Text("Leave the address out, or enter one of this machine.")};
}

std::uint16_t portOf(int listener) {
    sockaddr_storage address{};
    socklen_t length = sizeof address;
    if (getsockname(listener, reinterpret_cast<sockaddr*>(&address), &length) != 0) return 0;
    return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                                               : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

}  // namespace

bool saysPortInUse(const Error& error) {
    return error.message.format() == portInUse(0).message.format();
}

Acceptor::Acceptor(int listener, std::size_t most, CancelToken stop, Serve serve)
    : listener_(listener),
      most_(most),
      stop_(std::move(stop)),
      serve_(std::move(serve)),
      port_(portOf(listener)) {}

Acceptor::~Acceptor() {
    stop_.cancel();
    if (thread_.joinable()) thread_.join();
    joinServers(false);
    ::close(listener_);
}

Result<std::unique_ptr<Acceptor>> Acceptor::start(const ListeningPlace& place, std::size_t most,
                                                  CancelToken stop, Serve serve) {
    MACULA_TRY(const int listener, listenAt(place));
    std::unique_ptr<Acceptor> acceptor(new Acceptor(listener, most, std::move(stop), std::move(serve)));
    try {
        acceptor->thread_ = std::thread([shared = acceptor.get()] { shared->acceptAll(); });
    } catch (const std::system_error&) {
        return Error{ErrorCode::outOfMemory,
                     Text("This machine has no means left to receive instances."),
                     {},
                     Text("Close other programs and try again.")};
    }
    return acceptor;
}

void Acceptor::joinServers(bool onlyDone) {
    for (auto server = servers_.begin(); server != servers_.end();) {
        if (onlyDone && !server->isDone.load()) {
            ++server;
            continue;
        }
        if (server->thread.joinable()) server->thread.join();
        server = servers_.erase(server);
    }
}

void Acceptor::serveInThread(const Connection& connection) {
    ++open_;
    Server& server = servers_.emplace_back();
    try {
        server.thread = std::thread([this, connection, &server] {
            serve_(connection);
            --open_;
            server.isDone = true;
        });
    } catch (const std::system_error&) {  // there are no more threads
        ::close(connection.socket);
        --open_;
        servers_.pop_back();
    }
}

void Acceptor::acceptAll() {
    while (!stop_.cancelled()) {
        pollfd watched{listener_, POLLIN, 0};
        const int ready = poll(&watched, 1, static_cast<int>(kAcceptSlice.count()));
        joinServers(true);
        if (ready <= 0) continue;
        Connection connection;
        socklen_t length = sizeof connection.from.bytes;
        connection.socket = accept4(listener_, reinterpret_cast<sockaddr*>(connection.from.bytes), &length,
                                    SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (connection.socket < 0) {
            // Where no descriptor is left, the connection stays in the queue, and poll returns at once.
            if (errno == EMFILE || errno == ENFILE) std::this_thread::sleep_for(kAcceptSlice);
            continue;
        }
        connection.from.length = length;
        connection.from.family = reinterpret_cast<const sockaddr*>(connection.from.bytes)->sa_family;
        if (open() >= most_)
            ::close(connection.socket);
        else
            serveInThread(connection);
    }
}

}  // namespace macula::net
