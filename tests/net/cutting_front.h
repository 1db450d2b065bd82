// A line to a server of loopback that is cut again and again, each time after so many bytes.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

namespace macula::net::test {

// The moments depend on the seed, and on nothing that a machine does.
class CuttingFront {
  public:
    // Each connection ends after `least` to `most` bytes from the server, on a logarithmic scale.
    CuttingFront(std::uint16_t target, std::size_t least, std::size_t most, unsigned seed);
    ~CuttingFront();
    CuttingFront(const CuttingFront&) = delete;
    CuttingFront& operator=(const CuttingFront&) = delete;

    std::uint16_t port() const { return port_; }
    int cuts() const { return cuts_.load(); }
    void stopCutting() { isCutting_ = false; }

  private:
    void accept();
    void serve(int client, std::size_t most);

    std::uint16_t target_;
    std::size_t least_;
    std::size_t most_;
    std::mt19937 random_;  // of the accepting thread
    std::uint16_t port_ = 0;
    int listener_ = -1;
    std::atomic<bool> isOver_ = false;
    std::atomic<bool> isCutting_ = true;
    std::atomic<int> cuts_ = 0;
    std::mutex mutex_;
    std::vector<int> sockets_;  // that are open
    std::vector<std::thread> connections_;
    std::thread accepting_;
};

}  // namespace macula::net::test
