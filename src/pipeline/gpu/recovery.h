// Going on after a device was lost: a driver was reset, updated or crashed, a card fell asleep or was taken
// out.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>

#include "base/result.h"
#include "pipeline/gpu/device.h"

namespace macula::gpu {

inline constexpr int kMostLosses = 3;  // the third loss within kLossWindow is an error
inline constexpr std::chrono::seconds kLossWindow{60};

// How often devices were lost lately. What is lost again and again is not lost by chance: then whoever counts
// stops, and says what can be done.
class LossCount {
  public:
    using Clock = std::chrono::steady_clock;

    // Counts a loss. False when it was one too many.
    bool mayGoOn(Clock::time_point now = Clock::now());

  private:
    std::deque<Clock::time_point> lately_;
};

Error lostTooOften();  // deviceLost

// A device for work that can begin anew. Used by one thread at a time.
class LastingDevice {
  public:
    using Use = std::function<Result<void>(const std::shared_ptr<Device>&)>;
    using Tell = std::function<void(const Text& sentence)>;

    // `tell` hears of each loss that is made good, in one sentence. Errors: those of Device::create, but for
    // losses, and lostTooOften.
    static Result<LastingDevice> open(Instance instance, DeviceOptions options, Tell tell);

    // Runs `use`, and again on another device if the one it had was lost. A device lives as long as `use` has
    // left something on it, also when it was lost: `use` leaves nothing where it fails. Errors: those of
    // `use` and of open().
    Result<void> run(const Use& use);

  private:
    LastingDevice(Instance instance, DeviceOptions options, Tell tell);
    Result<void> ensureDevice();
    Result<void> countLoss();  // lostTooOften when it was one too many

    Instance instance_;
    DeviceOptions options_;
    Tell tell_;
    LossCount losses_;
    std::shared_ptr<Device> device_;  // null until it is made, and after a loss
};

}  // namespace macula::gpu
