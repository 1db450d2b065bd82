// How often a hand that moves a picture is heard of, and so how long the device is free between two frames:
// the rules alone, without device or clock.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>

namespace macula::app {

class HandRhythm {
  public:
    using TimePoint = std::chrono::steady_clock::time_point;
    static constexpr std::size_t kRemembered = 6;            // gaps between inputs
    static constexpr std::chrono::milliseconds kPause{100};  // a longer one is no part of a rhythm
    static constexpr double kReserveMs = 1.0;                // inputs come a little sooner or later

    // An input that was published then; `moves`: of a hand that moves something.
    void input(TimePoint published, bool moves);
    // Until the next one is due, by the shortest of the last gaps. 0: it is due, or nobody knows.
    double leftMs(TimePoint now) const;

  private:
    std::optional<TimePoint> last_;  // while a hand moves
    std::deque<std::chrono::steady_clock::duration> gaps_;
};

}  // namespace macula::app
