#include "net/dimse/wire.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "net/archive/broken_pipe.h"
#include "net/dimse/failures.h"
#include "net/dimse/tls.h"

namespace macula::net {

namespace {

using WireClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kSlice{50};
// How long what has begun may go on after it was cancelled.
constexpr std::chrono::milliseconds kGrace{1000};

// Many archives write the head of a PDU and its body one after the other, and the second waits until the
// first is acknowledged, which takes this machine 40 ms. The kernel forgets this setting.
void acknowledgeAtOnce(int socket) {
    const int isOn = 1;
    setsockopt(socket, IPPROTO_TCP, TCP_QUICKACK, &isOn, sizeof isOn);
}

// A search for a name that goes on after nobody waits for it any more: the C library cannot stop it.
struct NameSearch {
    std::mutex mutex;
    std::condition_variable ended;
    bool isDone = false;
    std::vector<WireAddress> found;
};

std::vector<WireAddress> searchName(const std::string& host, std::uint16_t port, int flags) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = flags | AI_NUMERICSERV;
    addrinfo* list = nullptr;
    std::vector<WireAddress> found;
    if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &list) != 0) return found;
    for (const addrinfo* each = list; each != nullptr; each = each->ai_next) {
        WireAddress address;
        if (each->ai_addrlen > sizeof address.bytes) continue;
        std::memcpy(address.bytes, each->ai_addr, each->ai_addrlen);
        address.length = each->ai_addrlen;
        address.family = each->ai_family;
        found.push_back(address);
    }
    freeaddrinfo(list);
    return found;
}

// 0, or errno of why there is no connection.
int awaitConnection(int socket, WireClock::time_point until, const CancelToken& cancel) {
    while (!cancel.cancelled()) {
        pollfd watched{socket, POLLOUT, 0};
        if (poll(&watched, 1, static_cast<int>(kSlice.count())) > 0) {
            int problem = 0;
            socklen_t length = sizeof problem;
            getsockopt(socket, SOL_SOCKET, SO_ERROR, &problem, &length);
            return problem;
        }
        if (WireClock::now() >= until) return ETIMEDOUT;
    }
    return ECANCELED;
}

void readyForDicom(int socket) {
    const int isOn = 1;
    // Requests and answers take turns, and are short.
    setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &isOn, sizeof isOn);
    setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &isOn, sizeof isOn);
    fcntl(socket, F_SETFL, fcntl(socket, F_GETFL, 0) | O_NONBLOCK);
}

}  // namespace

struct Wire::Tls {
    SSL* session = nullptr;
    ~Tls() { SSL_free(session); }
};

Result<std::vector<WireAddress>> addressesOf(const WireTarget& target, const CancelToken& cancel) {
    std::vector<WireAddress> numbers = searchName(target.host, target.port, AI_NUMERICHOST);
    if (!numbers.empty()) return numbers;
    const auto search = std::make_shared<NameSearch>();
    const auto work = [search, host = target.host, port = target.port] {
        std::vector<WireAddress> found = searchName(host, port, 0);
        const std::lock_guard lock(search->mutex);
        search->found = std::move(found);
        search->isDone = true;
        search->ended.notify_all();
    };
    try {
        std::thread(work).detach();
    } catch (const std::system_error&) {
        work();  // there are no more threads: nobody can cancel it then
    }
    const auto until = WireClock::now() + target.connectTimeout;
    std::unique_lock lock(search->mutex);
    while (!search->isDone) {
        if (cancel.cancelled()) return cancelledError();
        if (WireClock::now() >= until) return unknownHost();
        search->ended.wait_for(lock, kSlice);
    }
    if (search->found.empty()) return unknownHost();
    return search->found;
}

Result<std::unique_ptr<Wire>> Wire::connect(const WireTarget& target,
                                            const std::vector<WireAddress>& addresses,
                                            const CancelToken& cancel) {
    int problem = EHOSTUNREACH;
    const auto until = Clock::now() + target.connectTimeout;
    for (std::size_t i = 0; i < addresses.size(); ++i) {
        const WireAddress& address = addresses[i];
        const int socket = ::socket(address.family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
        if (socket < 0) continue;
        // Where one address does not answer, another may.
        const auto now = Clock::now();
        const auto share = std::max(until - now, Clock::duration::zero()) / (addresses.size() - i);
        problem = 0;
        if (::connect(socket, reinterpret_cast<const sockaddr*>(address.bytes), address.length) != 0)
            problem = errno == EINPROGRESS ? awaitConnection(socket, now + share, cancel) : errno;
        if (problem == 0) return std::make_unique<Wire>(socket, target.answerTimeout, cancel);
        close(socket);
        if (problem == ECANCELED) return cancelledError();
    }
    return errorOfConnecting(problem);
}

Wire::Wire(int socket, std::chrono::milliseconds answerTimeout, CancelToken cancel)
    : socket_(socket), answerTimeout_(answerTimeout), cancel_(std::move(cancel)) {
    readyForDicom(socket_);
}

Wire::~Wire() {
    if (tls_ && trouble_ == WireTrouble::none) {
        const WithoutBrokenPipes guarded;
        SSL_shutdown(tls_->session);
    }
    tls_.reset();
    close(socket_);
}

std::size_t Wire::fail(WireTrouble trouble) {
    if (trouble_ == WireTrouble::none) trouble_ = trouble;
    return 0;
}

Wire::Clock::time_point Wire::deadline() const {
    auto until = Clock::now() + answerTimeout_;
    if (end_) until = std::min(*end_, until);
    return finish_ ? std::min(*finish_, until) : until;
}

void Wire::finishWithin(std::chrono::milliseconds patience) {
    finish_ = Clock::now() + patience;
}

std::size_t Wire::came(std::size_t count) {
    if (heartbeat_) heartbeat_->beat();
    return count;
}

bool Wire::awaits(short events, Clock::time_point until) {
    std::optional<Clock::time_point> grace;
    if (events == POLLIN) acknowledgeAtOnce(socket_);
    while (true) {
        pollfd watched{socket_, events, 0};
        const int ready = poll(&watched, 1, static_cast<int>(kSlice.count()));
        if (ready > 0) return true;
        if (ready < 0 && errno != EINTR) return fail(WireTrouble::closed) != 0;
        const auto now = Clock::now();
        if (now >= until) return fail(WireTrouble::timedOut) != 0;
        if (finish_ || !cancel_.cancelled()) continue;
        if (!grace) grace = now + kGrace;
        if (now >= *grace) return fail(WireTrouble::cancelled) != 0;
    }
}

WireTrouble Wire::wait() {
    if (trouble_ != WireTrouble::none) return trouble_;
    if (tls_ && SSL_pending(tls_->session) > 0) return WireTrouble::none;
    const auto until = deadline();
    acknowledgeAtOnce(socket_);
    while (true) {
        // The connection lives on: whoever waits can still tell the peer.
        if (!finish_ && cancel_.cancelled()) return WireTrouble::cancelled;
        pollfd watched{socket_, POLLIN, 0};
        const int ready = poll(&watched, 1, static_cast<int>(kSlice.count()));
        if (ready > 0) return WireTrouble::none;
        if (ready < 0 && errno != EINTR) fail(WireTrouble::closed);
        const auto now = Clock::now();
        const bool isAlive = heartbeat_ && !finish_ && now < heartbeat_->last() + answerTimeout_;
        if (now >= until && !isAlive) fail(WireTrouble::timedOut);
        if (trouble_ != WireTrouble::none) return trouble_;
    }
}

bool Wire::waitToTheEnd() {
    const WireTrouble trouble = wait();
    if (trouble != WireTrouble::none) fail(trouble);
    return trouble == WireTrouble::none;
}

std::size_t Wire::read(void* bytes, std::size_t most) {
    if (trouble_ != WireTrouble::none || most == 0) return 0;
    return tls_ ? readTls(bytes, most) : readPlain(bytes, most);
}

std::size_t Wire::readPlain(void* bytes, std::size_t most) {
    const auto until = deadline();
    while (true) {
        const ssize_t count = recv(socket_, bytes, most, 0);
        if (count > 0) return came(static_cast<std::size_t>(count));
        if (count == 0) return fail(WireTrouble::closed);
        if (errno == EINTR) continue;
        if (errno != EAGAIN && errno != EWOULDBLOCK) return fail(WireTrouble::closed);
        if (!awaits(POLLIN, until)) return 0;
    }
}

bool Wire::awaitsTls(int result, Clock::time_point until) {
    switch (SSL_get_error(tls_->session, result)) {
        case SSL_ERROR_WANT_READ:
            return awaits(POLLIN, until);
        case SSL_ERROR_WANT_WRITE:
            return awaits(POLLOUT, until);
        default:
            return fail(WireTrouble::closed) != 0;
    }
}

std::size_t Wire::readTls(void* bytes, std::size_t most) {
    const auto until = deadline();
    const WithoutBrokenPipes guarded;
    while (true) {
        ERR_clear_error();
        const int count =
            SSL_read(tls_->session, bytes, static_cast<int>(std::min<std::size_t>(most, INT_MAX)));
        if (count > 0) return came(static_cast<std::size_t>(count));
        if (!awaitsTls(count, until)) return 0;
    }
}

bool Wire::write(const void* bytes, std::size_t count) {
    const WithoutBrokenPipes guarded;
    const char* at = static_cast<const char*>(bytes);
    while (count > 0 && trouble_ == WireTrouble::none) {
        ssize_t written = 0;
        if (tls_) {
            ERR_clear_error();
            written = SSL_write(tls_->session, at, static_cast<int>(std::min<std::size_t>(count, INT_MAX)));
            if (written <= 0 && !awaitsTls(static_cast<int>(written), deadline())) return false;
        } else {
            written = send(socket_, at, count, MSG_NOSIGNAL);
            if (written < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
                if (!awaits(POLLOUT, deadline())) return false;
            } else if (written < 0 && errno != EINTR) {
                return fail(WireTrouble::closed) != 0;
            }
        }
        if (written <= 0) continue;
        at += written;
        count -= static_cast<std::size_t>(written);
    }
    return trouble_ == WireTrouble::none;
}

namespace {

// The session checks the peer's certificate against the name by which the peer was asked for.
bool expectHost(SSL* session, const std::string& host) {
    X509_VERIFY_PARAM* expected = SSL_get0_param(session);
    unsigned char number[sizeof(in6_addr)];
    if (inet_pton(AF_INET, host.c_str(), number) == 1 || inet_pton(AF_INET6, host.c_str(), number) == 1)
        return X509_VERIFY_PARAM_set1_ip_asc(expected, host.c_str()) == 1;
    X509_VERIFY_PARAM_set_hostflags(expected, X509_CHECK_FLAG_NO_PARTIAL_WILDCARDS);
    return X509_VERIFY_PARAM_set1_host(expected, host.c_str(), 0) == 1 &&
           SSL_set_tlsext_host_name(session, host.c_str()) == 1;
}

Error errorOfHandshake(SSL* session, WireTrouble trouble, unsigned long problem) {
    if (trouble == WireTrouble::cancelled) return cancelledError();
    if (trouble == WireTrouble::timedOut)
        return archiveError(Text("The archive did not answer when a protected connection was to begin."),
                            Text("Check that this port of the archive is the one for TLS."));
    const long verified = SSL_get_verify_result(session);
    if (verified != X509_V_OK) return errorOfCertificate(verified);
    switch (ERR_GET_REASON(problem)) {
        case SSL_R_WRONG_VERSION_NUMBER:
        case SSL_R_UNKNOWN_PROTOCOL:
        case SSL_R_HTTP_REQUEST:
            return archiveError(
                Text("The archive does not use TLS at this port."),
                Text("Enter the port for TLS, or switch TLS off if the network is safe without."));
        case SSL_R_TLSV1_ALERT_PROTOCOL_VERSION:
        case SSL_R_UNSUPPORTED_PROTOCOL:
        case SSL_R_SSLV3_ALERT_HANDSHAKE_FAILURE:
        case SSL_R_NO_SHARED_CIPHER:
            return archiveError(
                Text("The archive and this program have no way of protecting a connection in common."),
                Text("The archive must offer TLS 1.2 or later with the ciphers of BCP 195."));
        case SSL_R_TLSV13_ALERT_CERTIFICATE_REQUIRED:
        case SSL_R_SSLV3_ALERT_BAD_CERTIFICATE:
        case SSL_R_SSLV3_ALERT_CERTIFICATE_UNKNOWN:
        case SSL_R_TLSV1_ALERT_UNKNOWN_CA:
            return archiveError(Text("The archive does not accept the certificate of this program."),
                                Text("Enter a certificate that the archive trusts, with its key."));
        default:
            return archiveError(
                Text("No protected connection to the archive could be made."),
                Text("Check that this port of the archive is the one for TLS, and whether it asks for a "
                     "certificate of this program."));
    }
}

}  // namespace

Result<void> Wire::beginTls(const TlsSettings& settings, const std::string& host,
                            std::chrono::milliseconds patience) {
    const WithoutBrokenPipes guarded;
    tls_ = std::make_unique<Tls>();
    tls_->session = SSL_new(settings.native());
    MACULA_CHECK(tls_->session != nullptr);
    const bool connects = settings.role() == TlsSettings::Role::connects;
    MACULA_CHECK_EQ(SSL_set_fd(tls_->session, socket_), 1);
    if (connects && !expectHost(tls_->session, host)) return unknownHost();
    const auto until = Clock::now() + patience;
    while (true) {
        ERR_clear_error();
        const int result = connects ? SSL_connect(tls_->session) : SSL_accept(tls_->session);
        if (result == 1) return {};
        const unsigned long problem = ERR_peek_last_error();
        if (!awaitsTls(result, until)) {
            const Error error = errorOfHandshake(tls_->session, trouble_, problem);
            tls_.reset();
            return error;
        }
    }
}

}  // namespace macula::net
