// A time budget that all stages of a job share.
#pragma once

#include <chrono>
#include <functional>
#include <limits>
#include <utility>

namespace macula {

// The time starts at construction; copies share that start.
class TimeBudget {
  public:
    using Clock = std::function<double()>;  // seconds since an arbitrary time; never goes back

    static double steadySeconds() {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }

    TimeBudget() : TimeBudget(std::numeric_limits<double>::infinity()) {}  // unlimited
    explicit TimeBudget(double seconds, Clock clock = steadySeconds)
        : clock_(std::move(clock)), seconds_(seconds), start_(clock_()) {}

    bool isLimited() const { return seconds_ < std::numeric_limits<double>::infinity(); }
    double spentSeconds() const { return clock_() - start_; }
    double leftSeconds() const { return seconds_ - spentSeconds(); }
    bool isSpent() const { return isLimited() && leftSeconds() <= 0.0; }

  private:
    Clock clock_;
    double seconds_;
    double start_;
};

}  // namespace macula
