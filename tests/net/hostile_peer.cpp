#include "net/hostile_peer.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace macula::net::test {

namespace {

void appendBig(Bytes& bytes, std::size_t number, int count) {
    for (int i = count - 1; i >= 0; --i) bytes.push_back(static_cast<unsigned char>(number >> (8 * i)));
}

void appendItem(Bytes& bytes, unsigned type, const Bytes& body) {
    appendBig(bytes, type, 1);
    appendBig(bytes, 0, 1);
    appendBig(bytes, body.size(), 2);
    bytes.insert(bytes.end(), body.begin(), body.end());
}

Bytes bytesOfText(const std::string& text) {
    return {text.begin(), text.end()};
}

std::size_t bigAt(const Bytes& bytes, std::size_t at, std::size_t count) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < count && at + i < bytes.size(); ++i) number = number << 8 | bytes[at + i];
    return number;
}

}  // namespace

bool HostileLine::sendAll(const Bytes& bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
        const ssize_t count = send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (count <= 0) return false;
        sent += static_cast<std::size_t>(count);
    }
    return true;
}

bool HostileLine::receiveAll(unsigned char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t had = recv(socket_, bytes, count, 0);
        if (had <= 0) return false;
        bytes += had;
        count -= static_cast<std::size_t>(had);
    }
    return true;
}

bool HostileLine::sendPdu(unsigned type, const Bytes& body) {
    Bytes pdu;
    appendBig(pdu, type, 1);
    appendBig(pdu, 0, 1);
    appendBig(pdu, body.size(), 4);
    pdu.insert(pdu.end(), body.begin(), body.end());
    return sendAll(pdu);
}

bool HostileLine::sendFragment(unsigned context, bool isCommand, bool isLast, const Bytes& bytes) {
    constexpr std::size_t kMost = 16000;
    std::size_t at = 0;
    do {
        const std::size_t count = std::min(kMost, bytes.size() - at);
        const bool ends = isLast && at + count == bytes.size();
        Bytes body;
        appendBig(body, count + 2, 4);
        appendBig(body, context, 1);
        appendBig(body, (isCommand ? 1u : 0u) | (ends ? 2u : 0u), 1);
        body.insert(body.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    bytes.begin() + static_cast<std::ptrdiff_t>(at + count));
        if (!sendPdu(4, body)) return false;
        at += count;
    } while (at < bytes.size());
    return true;
}

bool HostileLine::sendCommand(unsigned context, const Command& command) {
    return sendFragment(context, true, true, bytesOf(command));
}

std::optional<std::pair<unsigned, Bytes>> HostileLine::receivePdu() {
    Bytes head(6);
    if (!receiveAll(head.data(), head.size())) return {};
    Bytes body(bigAt(head, 2, 4));
    if (!receiveAll(body.data(), body.size())) return {};
    return std::pair<unsigned, Bytes>{head[0], body};
}

std::optional<HostileLine::Received> HostileLine::receiveCommand() {
    Bytes bytes;
    while (const auto pdu = receivePdu()) {
        if (pdu->first == 5) {  // release
            sendPdu(6, Bytes(4));
            return {};
        }
        if (pdu->first != 4) return {};
        for (std::size_t at = 0; at + 6 <= pdu->second.size();) {
            const std::size_t length = bigAt(pdu->second, at, 4);
            const unsigned context = pdu->second[at + 4];
            const unsigned flags = pdu->second[at + 5];
            if ((flags & 1u) != 0) {
                bytes.insert(bytes.end(), pdu->second.begin() + static_cast<std::ptrdiff_t>(at + 6),
                             pdu->second.begin() + static_cast<std::ptrdiff_t>(at + 4 + length));
                const auto command = (flags & 2u) != 0 ? commandOf(bytes) : std::nullopt;
                if (command) return Received{context, *command};
            }
            at += 4 + length;
        }
    }
    return {};
}

std::optional<HostileLine::Received> HostileLine::receiveCommandOf(CommandField field) {
    while (auto received = receiveCommand())
        if (received->command.field == field) return received;
    return {};
}

bool HostileLine::requestAssociation(const std::string& calledAe, const std::string& sopClassUid,
                                     const std::string& transferSyntaxUid) {
    Bytes request{0, 1, 0, 0};
    std::string titles = calledAe;
    titles.resize(16, ' ');
    titles += "HOSTILE         ";
    request.insert(request.end(), titles.begin(), titles.end());
    request.resize(68, 0);
    appendItem(request, 0x10, bytesOfText("1.2.840.10008.3.1.1.1"));
    Bytes context{1, 0, 0, 0};
    appendItem(context, 0x30, bytesOfText(sopClassUid));
    appendItem(context, 0x40, bytesOfText(transferSyntaxUid));
    appendItem(request, 0x20, context);
    Bytes user;
    appendItem(user, 0x51, {0, 0, 0x40, 0});
    appendItem(user, 0x52, bytesOfText("1.2.3"));
    appendItem(request, 0x50, user);
    if (!sendPdu(1, request)) return false;
    const auto answer = receivePdu();
    contexts_[1] = {sopClassUid, transferSyntaxUid};
    rejection_.clear();
    if (answer && answer->first == 3 && answer->second.size() == 4)
        rejection_ = {answer->second[1], answer->second[2], answer->second[3]};
    return answer && answer->first == 2;
}

bool HostileLine::acceptAssociation() {
    const auto request = receivePdu();
    if (!request || request->first != 1 || request->second.size() < 68) return false;
    const Bytes& body = request->second;
    calledAe_.assign(body.begin() + 4, body.begin() + 20);
    Bytes answer(body.begin(), body.begin() + 68);
    for (std::size_t at = 68; at + 4 <= body.size();) {
        const std::size_t length = bigAt(body, at + 2, 2);
        const Bytes item(body.begin() + static_cast<std::ptrdiff_t>(at + 4),
                         body.begin() + static_cast<std::ptrdiff_t>(at + 4 + length));
        if (body[at] == 0x10) appendItem(answer, 0x10, item);
        if (body[at] == 0x20) {
            std::string abstractSyntax;
            std::string transferSyntax;
            for (std::size_t sub = 4; sub + 4 <= item.size();) {
                const std::size_t subLength = bigAt(item, sub + 2, 2);
                const std::string text(item.begin() + static_cast<std::ptrdiff_t>(sub + 4),
                                       item.begin() + static_cast<std::ptrdiff_t>(sub + 4 + subLength));
                if (item[sub] == 0x30) abstractSyntax = text;
                if (item[sub] == 0x40 && transferSyntax.empty()) transferSyntax = text;
                sub += 4 + subLength;
            }
            contexts_[item[0]] = {abstractSyntax, transferSyntax};
            Bytes accepted{item[0], 0, 0, 0};
            appendItem(accepted, 0x40, bytesOfText(transferSyntax));
            appendItem(answer, 0x21, accepted);
        }
        at += 4 + length;
    }
    Bytes user;
    appendItem(user, 0x51, {0, 0, 0x40, 0});
    appendItem(user, 0x52, bytesOfText("1.2.3"));
    appendItem(answer, 0x50, user);
    return sendPdu(2, answer);
}

unsigned HostileLine::contextOf(const std::string& sopClassUid) const {
    for (const auto& [id, syntaxes] : contexts_)
        if (syntaxes.first == sopClassUid) return id;
    return 0;
}

HostilePeer::HostilePeer(Script script) : script_(std::move(script)) {
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    EXPECT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&address), length), 0);
    EXPECT_EQ(listen(listener_, 8), 0);
    EXPECT_EQ(getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &length), 0);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
}

HostilePeer::~HostilePeer() {
    ends_ = true;
    const int open = open_.load();
    if (open >= 0) shutdown(open, SHUT_RDWR);
    thread_.join();
    close(listener_);
}

void HostilePeer::serve() {
    while (!ends_.load()) {
        pollfd watched{listener_, POLLIN, 0};
        if (poll(&watched, 1, 20) <= 0) continue;
        const int socket = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        if (socket < 0) continue;
        open_ = socket;
        ++connections_;
        if (ends_.load()) shutdown(socket, SHUT_RDWR);
        HostileLine line(socket);
        script_(line);
        open_ = -1;
        close(socket);
    }
}

int connectionTo(std::uint16_t port) {
    const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    return connection;
}

Bytes explicitElement(std::uint32_t tag, const std::string& representation, std::string value) {
    if (value.size() % 2 != 0) value += representation == "UI" ? '\0' : ' ';
    Bytes bytes;
    const auto little = [&](std::size_t number, int count) {
        for (int i = 0; i < count; ++i) bytes.push_back(static_cast<unsigned char>(number >> (8 * i)));
    };
    little(tag >> 16, 2);
    little(tag & 0xffffu, 2);
    bytes.insert(bytes.end(), representation.begin(), representation.end());
    const bool isLong = representation == "OB" || representation == "OW" || representation == "SQ";
    if (isLong) little(0, 2);
    little(value.size(), isLong ? 4 : 2);
    bytes.insert(bytes.end(), value.begin(), value.end());
    return bytes;
}

Bytes joined(const std::vector<Bytes>& parts) {
    Bytes all;
    for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace macula::net::test
