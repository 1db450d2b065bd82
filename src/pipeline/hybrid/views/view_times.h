// Where the time goes in which views to learn from are made.
#pragma once

#include <chrono>

namespace macula::hybrid {

// Seconds by the clock of the thread that uses the device. Where that goes on while the device works, what it
// waited for counts where it waited.
struct ViewTimes {
    double poses = 0.0;       // choosing where views look from
    double paths = 0.0;       // tracing paths of light
    double reading = 0.0;     // guides, filter, and the way to the host, as far as that was waited for
    double lightTable = 0.0;  // the light of all views, put in order and brought to the device
    double lighting = 0.0;    // marching views through that light, and their way to the host
    double waiting = 0.0;     // for what the host does beside
    double beside = 0.0;      // that this took, on other threads: part of no sum
    double toTrainer = 0.0;   // what a trainer took to get them on the device: part of the time of training
};

// Adds the time until the end of its scope.
class Lap {
  public:
    explicit Lap(double& seconds) : seconds_(seconds) {}
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;
    ~Lap() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    double& seconds_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace macula::hybrid
