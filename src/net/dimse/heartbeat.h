// When something came last, over any of several connections that do one thing together.
#pragma once

#include <atomic>
#include <chrono>

namespace macula::net {

class Heartbeat {
  public:
    using Clock = std::chrono::steady_clock;
    void beat() { last_.store(Clock::now().time_since_epoch().count(), std::memory_order_relaxed); }
    Clock::time_point last() const {
        return Clock::time_point(Clock::duration(last_.load(std::memory_order_relaxed)));
    }

  private:
    std::atomic<Clock::rep> last_{Clock::now().time_since_epoch().count()};
};

}  // namespace macula::net
