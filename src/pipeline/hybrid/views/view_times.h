// Where time is spent when training views are made.
#pragma once

#include <chrono>

namespace macula::hybrid {

// Wall seconds of the thread that uses the device. That thread does not always wait for the device: the time
// of waiting counts in the part that waits.
struct ViewTimes {
    double poses = 0.0;       // choosing where views look from
    double paths = 0.0;       // tracing paths of light
    double reading = 0.0;     // guides, denoiser, and waiting for copies to the host
    double lightTable = 0.0;  // sorting the light of all views, and uploading it
    double lighting = 0.0;    // marching views through that light, and copies to the host
    double waiting = 0.0;     // waiting for the host's parallel work
    double beside = 0.0;      // of that work, on other threads: not part of a sum
    double toTrainer = 0.0;   // uploading them for a trainer: part of training time
};

// Adds the time of its scope to `seconds`.
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
