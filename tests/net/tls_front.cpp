#include "net/tls_front.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace macula::net::test {

namespace {

sockaddr_in loopbackAt(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    return address;
}

bool sendAll(int socket, const char* bytes, int count) {
    while (count > 0) {
        const ssize_t sent = send(socket, bytes, static_cast<std::size_t>(count), MSG_NOSIGNAL);
        if (sent <= 0) return false;
        bytes += sent;
        count -= static_cast<int>(sent);
    }
    return true;
}

// Both ways, until one side has gone.
void pump(SSL* client, int clientSocket, int server) {
    std::array<char, 16384> bytes{};
    while (true) {
        std::array<pollfd, 2> both{{{clientSocket, POLLIN, 0}, {server, POLLIN, 0}}};
        if (SSL_pending(client) == 0 && poll(both.data(), both.size(), -1) < 0) return;
        if (SSL_pending(client) > 0 || both[0].revents != 0) {
            const int got = SSL_read(client, bytes.data(), static_cast<int>(bytes.size()));
            if (got <= 0 || !sendAll(server, bytes.data(), got)) return;
        }
        if (both[1].revents != 0) {
            const ssize_t got = recv(server, bytes.data(), bytes.size(), 0);
            if (got <= 0 || SSL_write(client, bytes.data(), static_cast<int>(got)) <= 0) return;
        }
    }
}

}  // namespace

TlsFront::TlsFront(const Certificate& certificate, std::uint16_t target, const std::filesystem::path& trusted)
    : context_(SSL_CTX_new(TLS_server_method()), SSL_CTX_free), target_(target) {
    EXPECT_EQ(SSL_CTX_use_certificate_file(context_.get(), certificate.certificate.c_str(), SSL_FILETYPE_PEM),
              1);
    EXPECT_EQ(SSL_CTX_use_PrivateKey_file(context_.get(), certificate.key.c_str(), SSL_FILETYPE_PEM), 1);
    if (!trusted.empty()) {
        EXPECT_EQ(SSL_CTX_load_verify_locations(context_.get(), trusted.c_str(), nullptr), 1);
        SSL_CTX_set_verify(context_.get(), SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, nullptr);
    }
    sockaddr_in address = loopbackAt(0);
    socklen_t size = sizeof address;
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(listener_, 64), 0);
    EXPECT_EQ(getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    port_ = ntohs(address.sin_port);
    accepting_ = std::thread([this] { accept(); });
}

TlsFront::~TlsFront() {
    isOver_ = true;
    shutdown(listener_, SHUT_RDWR);
    accepting_.join();
    close(listener_);
    {
        const std::lock_guard guard(mutex_);
        for (const int socket : sockets_) shutdown(socket, SHUT_RDWR);
    }
    for (std::thread& connection : connections_) connection.join();
    for (const int socket : sockets_) close(socket);
}

int TlsFront::kept(int socket) {
    const std::lock_guard guard(mutex_);
    sockets_.push_back(socket);
    if (isOver_) shutdown(socket, SHUT_RDWR);
    return socket;
}

void TlsFront::accept() {
    while (!isOver_) {
        const int client = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        if (client < 0) continue;
        kept(client);
        connections_.emplace_back([this, client] { serve(client); });
    }
}

void TlsFront::serve(int client) {
    sigset_t pipe;  // OpenSSL writes to sockets that the client has closed
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
    const std::unique_ptr<SSL, decltype(&SSL_free)> tls(SSL_new(context_.get()), SSL_free);
    SSL_set_fd(tls.get(), client);
    if (SSL_accept(tls.get()) == 1) {
        const int server = kept(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
        sockaddr_in address = loopbackAt(target_);
        if (connect(server, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0)
            pump(tls.get(), client, server);
        shutdown(server, SHUT_RDWR);
        SSL_shutdown(tls.get());
    } else {
        // Until the client has read why: bytes of it that nobody reads would take the alert away.
        std::array<char, 4096> ignored{};
        shutdown(client, SHUT_WR);
        while (recv(client, ignored.data(), ignored.size(), 0) > 0) {
        }
    }
    shutdown(client, SHUT_RDWR);
}

}  // namespace macula::net::test
