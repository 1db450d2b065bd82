#include "net/cutting_front.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "net/hostile_peer.h"

namespace macula::net::test {

namespace {

bool sendAll(int socket, const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t sent = send(socket, bytes, count, MSG_NOSIGNAL);
        if (sent <= 0) return false;
        bytes += sent;
        count -= static_cast<std::size_t>(sent);
    }
    return true;
}

}  // namespace

CuttingFront::CuttingFront(std::uint16_t target, std::size_t least, std::size_t most, unsigned seed)
    : target_(target), least_(least), most_(most), random_(seed) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(listener_, 64), 0);
    EXPECT_EQ(getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    port_ = ntohs(address.sin_port);
    accepting_ = std::thread([this] { accept(); });
}

CuttingFront::~CuttingFront() {
    isOver_ = true;
    shutdown(listener_, SHUT_RDWR);
    accepting_.join();
    close(listener_);
    {
        const std::lock_guard guard(mutex_);
        for (const int socket : sockets_) shutdown(socket, SHUT_RDWR);
    }
    for (std::thread& connection : connections_) connection.join();
}

void CuttingFront::accept() {
    std::uniform_real_distribution<double> logarithm(std::log(static_cast<double>(least_)),
                                                     std::log(static_cast<double>(most_)));
    while (!isOver_) {
        const int client = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        if (client < 0) continue;
        const auto most = static_cast<std::size_t>(std::exp(logarithm(random_)));
        connections_.emplace_back([this, client, most] { serve(client, most); });
    }
}

void CuttingFront::serve(int client, std::size_t most) {
    const int server = connectionTo(target_);
    {
        const std::lock_guard guard(mutex_);
        sockets_.insert(sockets_.end(), {client, server});
        if (isOver_) shutdown(client, SHUT_RDWR);
    }
    std::array<char, 16384> bytes{};
    std::size_t left = most;
    while (true) {
        std::array<pollfd, 2> both{{{client, POLLIN, 0}, {server, POLLIN, 0}}};
        if (poll(both.data(), both.size(), -1) < 0) break;
        if (both[0].revents != 0) {
            const ssize_t got = recv(client, bytes.data(), bytes.size(), 0);
            if (got <= 0 || !sendAll(server, bytes.data(), static_cast<std::size_t>(got))) break;
        }
        if (both[1].revents != 0) {
            const ssize_t got = recv(server, bytes.data(), bytes.size(), 0);
            if (got <= 0) break;
            const bool cuts = isCutting_ && static_cast<std::size_t>(got) >= left;
            const std::size_t passed = cuts ? left : static_cast<std::size_t>(got);
            if (!sendAll(client, bytes.data(), passed)) break;
            if (cuts) {
                ++cuts_;
                break;
            }
            left -= std::min(left, passed);
        }
    }
    const std::lock_guard guard(mutex_);
    for (const int socket : {client, server}) {
        std::erase(sockets_, socket);
        close(socket);
    }
}

}  // namespace macula::net::test
