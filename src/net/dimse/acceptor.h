// Accepts connections at a port of this machine, and serves each in a thread of its own.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <thread>

#include "base/progress.h"
#include "base/result.h"
#include "net/dimse/wire.h"

namespace macula::net {

struct ListeningPlace {
    std::string address;     // empty: all addresses of this machine
    std::uint16_t port = 0;  // 0: any that is free
};

// Whether a start failed because somebody else listens there.
bool saysPortInUse(const Error& error);

class Acceptor {
  public:
    struct Connection {
        int socket = -1;  // whoever serves the connection owns it
        WireAddress from;
    };
    using Serve = std::function<void(const Connection&)>;

    // Closes what comes while `most` connections are served. `stop` must end what `serve` does: it is
    // cancelled when the acceptor goes, which waits for all that is served. Fails with usage where the port
    // or the address cannot be listened at.
    static Result<std::unique_ptr<Acceptor>> start(const ListeningPlace& place, std::size_t most,
                                                   CancelToken stop, Serve serve);
    ~Acceptor();
    Acceptor(const Acceptor&) = delete;
    Acceptor& operator=(const Acceptor&) = delete;

    std::uint16_t port() const { return port_; }
    std::size_t open() const { return open_.load(); }

  private:
    // Of the accepting thread alone, until that has ended.
    struct Server {
        std::atomic<bool> isDone{false};
        std::thread thread;
    };

    Acceptor(int listener, std::size_t most, CancelToken stop, Serve serve);
    void acceptAll();
    void serveInThread(const Connection& connection);
    void joinServers(bool onlyDone);

    const int listener_;
    const std::size_t most_;
    const CancelToken stop_;
    const Serve serve_;
    std::uint16_t port_ = 0;
    std::atomic<std::size_t> open_{0};
    std::list<Server> servers_;
    std::thread thread_;
};

}  // namespace macula::net
