// Predicts when the next input of a moving hand is due, and so how long the device is free between two
// frames. Holds the rules alone: no device, no clock.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <optional>

namespace macula::live {

class HandRhythm {
  public:
    using TimePoint = std::chrono::steady_clock::time_point;
    static constexpr std::size_t kRemembered = 6;            // gaps between inputs
    static constexpr std::chrono::milliseconds kPause{100};  // a longer gap restarts the rhythm
    static constexpr double kReserveMs = 1.0;                // subtracted: inputs may come early

    // Reports an input and when it was published. `moves`: a hand is moving something.
    void input(TimePoint published, bool moves);
    // Milliseconds until the next input is due, by the shortest recent gap. 0: it is due, or unknown.
    double leftMs(TimePoint now) const;

  private:
    std::optional<TimePoint> last_;  // the last input; only while a hand moves
    std::deque<std::chrono::steady_clock::duration> gaps_;
};

}  // namespace macula::live
