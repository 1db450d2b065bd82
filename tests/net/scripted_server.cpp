#include "net/scripted_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "base/parsing.h"

namespace macula::net::test {

namespace {

bool receiveMore(int socket, std::string& bytes) {
    char some[65536];
    const ssize_t got = recv(socket, some, sizeof some, 0);
    if (got <= 0) return false;
    bytes.append(some, static_cast<std::size_t>(got));
    return true;
}

std::size_t lengthIn(const std::string& headers) {
    const std::string name = "content-length:";
    const std::string small = lowerCase(headers);
    const std::size_t at = small.find(name);
    if (at == std::string::npos) return 0;
    const std::size_t end = small.find('\r', at);
    return parseNumber<std::size_t>(trimmed(small.substr(at + name.size(), end - at - name.size())))
        .value_or(0);
}

}  // namespace

bool ScriptedServer::Peer::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

void ScriptedServer::Peer::answer(int status, const std::string& type, const std::string& body,
                                  const std::string& moreHeaders) {
    std::string head = "HTTP/1.1 " + std::to_string(status) +
                       " Status\r\nContent-Length: " + std::to_string(body.size()) + "\r\n" + moreHeaders;
    if (!type.empty()) head += "Content-Type: " + type + "\r\n";
    send(head + "\r\n" + body);
    isKept = true;
}

void ScriptedServer::Peer::waitUntilGone() {
    std::string ignored;
    while (receiveMore(socket_, ignored)) ignored.clear();
}

ScriptedServer::ScriptedServer(Answer answer, std::string greeting)
    : answer_(std::move(answer)), greeting_(std::move(greeting)) {
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(bind(listener_, generic, size), 0);
    EXPECT_EQ(listen(listener_, 64), 0);
    EXPECT_EQ(getsockname(listener_, generic, &size), 0);
    port_ = ntohs(address.sin_port);
    accepting_ = std::thread([this] { accept(); });
}

ScriptedServer::~ScriptedServer() {
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

std::string ScriptedServer::url() const {
    return "http://127.0.0.1:" + std::to_string(port_);
}

std::vector<ScriptedServer::Request> ScriptedServer::requests() const {
    const std::lock_guard guard(mutex_);
    return requests_;
}

void ScriptedServer::accept() {
    while (!isOver_) {
        const int socket = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        if (socket < 0) continue;
        const std::lock_guard guard(mutex_);
        sockets_.push_back(socket);
        connections_.emplace_back([this, socket] { serve(socket); });
    }
}

void ScriptedServer::serve(int socket) {
    std::string bytes;
    Peer peer(socket);
    if (!greeting_.empty()) {
        receiveMore(socket, bytes);
        peer.send(greeting_);
        shutdown(socket, SHUT_RDWR);
        return;
    }
    while (true) {
        peer.isKept = false;
        std::size_t end = bytes.find("\r\n\r\n");
        while (end == std::string::npos) {
            if (!receiveMore(socket, bytes)) return;
            end = bytes.find("\r\n\r\n");
        }
        Request request;
        request.headers = bytes.substr(0, end + 2);
        const std::size_t length = lengthIn(request.headers);
        bytes.erase(0, end + 4);
        while (bytes.size() < length)
            if (!receiveMore(socket, bytes)) return;
        request.body = bytes.substr(0, length);
        bytes.erase(0, length);
        const std::size_t blank = request.headers.find(' ');
        request.method = request.headers.substr(0, blank);
        request.target = request.headers.substr(blank + 1, request.headers.find(' ', blank + 1) - blank - 1);
        {
            const std::lock_guard guard(mutex_);
            requests_.push_back(request);
        }
        answer_(request, peer);
        if (peer.isKept) continue;
        shutdown(socket, SHUT_RDWR);
        return;
    }
}

std::string multipartOf(const std::vector<std::string>& parts, const std::string& boundary) {
    std::string body;
    for (const std::string& part : parts)
        body += "\r\n--" + boundary + "\r\nContent-Type: application/dicom\r\n\r\n" + part;
    return body + "\r\n--" + boundary + "--\r\n";
}

}  // namespace macula::net::test
