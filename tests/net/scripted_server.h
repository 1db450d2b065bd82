// A server of HTTP on loopback whose answers a test writes byte by byte, well or hostile.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace macula::net::test {

class ScriptedServer {
  public:
    struct Request {
        std::string method;
        std::string target;   // as the client encoded it
        std::string headers;  // all lines
        std::string body;

        bool has(std::string_view text) const { return headers.find(text) != std::string::npos; }
    };
    class Peer {
      public:
        explicit Peer(int socket) : socket_(socket) {}
        bool send(std::string_view bytes);  // false: the client has gone
        // A whole answer with its length.
        void answer(int status, const std::string& type, const std::string& body,
                    const std::string& moreHeaders = {});
        void waitUntilGone();  // says nothing any more
        bool isKept = false;   // the connection takes another request

      private:
        int socket_;
    };
    // Called in a thread of the connection, which closes when it returns.
    using Answer = std::function<void(const Request&, Peer&)>;

    // `greeting`: what it says at once, whatever it is asked.
    explicit ScriptedServer(Answer answer, std::string greeting = {});
    ~ScriptedServer();
    ScriptedServer(const ScriptedServer&) = delete;
    ScriptedServer& operator=(const ScriptedServer&) = delete;

    std::uint16_t port() const { return port_; }
    std::string url() const;
    std::vector<Request> requests() const;

  private:
    void accept();
    void serve(int socket);

    Answer answer_;
    std::string greeting_;
    int listener_ = -1;
    std::uint16_t port_ = 0;
    std::atomic<bool> isOver_ = false;
    mutable std::mutex mutex_;
    std::vector<Request> requests_;
    std::vector<int> sockets_;
    std::vector<std::thread> connections_;
    std::thread accepting_;
};

// A body of multipart/related with these parts.
std::string multipartOf(const std::vector<std::string>& parts, const std::string& boundary);

}  // namespace macula::net::test
