// How long work that tells its progress will still take.
#pragma once

#include <QString>
#include <chrono>
#include <optional>

namespace macula::viewer {

class TimeLeft {
  public:
    using Clock = std::chrono::steady_clock;

    void begin(Clock::time_point now = Clock::now()) { begun_ = now; }
    // Nothing in the first seconds, and while hardly anything is done. `fraction`: 0 to 1, of all of it.
    std::optional<std::chrono::seconds> after(double fraction, Clock::time_point now = Clock::now()) const;

  private:
    Clock::time_point begun_ = Clock::now();
};

// "20 s left", "3 min left".
QString timeLeftText(std::chrono::seconds left);

}  // namespace macula::viewer
