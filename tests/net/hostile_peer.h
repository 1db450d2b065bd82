// An archive that breaks rules: PDUs of PS3.8 made by hand, over plain sockets.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "net/dimse/command.h"

namespace macula::net::test {

using Bytes = std::vector<unsigned char>;

// One connection, seen from the archive.
class HostileLine {
  public:
    explicit HostileLine(int socket) : socket_(socket) {}

    // False when the other side is gone.
    bool sendAll(const Bytes& bytes);
    bool sendPdu(unsigned type, const Bytes& body);
    bool sendFragment(unsigned context, bool isCommand, bool isLast, const Bytes& bytes);
    bool sendCommand(unsigned context, const Command& command);
    // The type of the next PDU and its body.
    std::optional<std::pair<unsigned, Bytes>> receivePdu();
    // Reads on to the last fragment of a command, over datasets; empty when there is none.
    struct Received {
        unsigned context = 0;
        Command command;
    };
    std::optional<Received> receiveCommand();
    std::optional<Received> receiveCommandOf(CommandField field);  // others are read over

    // Asks for an association with one context (1); whether it is accepted.
    bool requestAssociation(const std::string& calledAe, const std::string& sopClassUid,
                            const std::string& transferSyntaxUid);
    // Of the last request that was rejected: result, source and reason, as 1, 1, 7.
    const std::vector<unsigned>& rejection() const { return rejection_; }
    // Accepts every context in its first transfer syntax.
    bool acceptAssociation();
    // The first one of that SOP class.
    unsigned contextOf(const std::string& sopClassUid) const;
    const std::string& calledAe() const { return calledAe_; }

  private:
    bool receiveAll(unsigned char* bytes, std::size_t count);
    int socket_;
    std::string calledAe_;
    std::vector<unsigned> rejection_;
    std::map<unsigned, std::pair<std::string, std::string>> contexts_;  // class, transfer syntax
};

// Serves connections on loopback, one after the other, each with the script.
class HostilePeer {
  public:
    using Script = std::function<void(HostileLine&)>;
    explicit HostilePeer(Script script);
    ~HostilePeer();
    HostilePeer(const HostilePeer&) = delete;
    HostilePeer& operator=(const HostilePeer&) = delete;

    std::uint16_t port() const { return port_; }
    int connections() const { return connections_.load(); }

  private:
    void serve();
    Script script_;
    int listener_ = -1;
    std::uint16_t port_ = 0;
    std::atomic<int> open_{-1};
    std::atomic<bool> ends_{false};
    std::atomic<int> connections_{0};
    std::thread thread_;
};

// A connection to a port of loopback.
int connectionTo(std::uint16_t port);

// Elements in Explicit VR Little Endian.
Bytes explicitElement(std::uint32_t tag, const std::string& representation, std::string value);
Bytes joined(const std::vector<Bytes>& parts);

}  // namespace macula::net::test
