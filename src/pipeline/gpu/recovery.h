// Continues after a device was lost: a driver was reset, updated or crashed, or a card went to sleep or was
// removed.
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

// Counts recent losses of devices. Repeated losses have a cause that a new device does not remove: the caller
// then stops, and tells the user what to do.
class LossCount {
  public:
    using Clock = std::chrono::steady_clock;

    // Counts a loss. False at the kMostLosses-th loss within kLossWindow.
    bool mayGoOn(Clock::time_point now = Clock::now());

  private:
    std::deque<Clock::time_point> lately_;
};

Error lostTooOften();  // has the code deviceLost

// A device for work that can be started again from the beginning. Used by one thread at a time.
class LastingDevice {
  public:
    using Use = std::function<Result<void>(const std::shared_ptr<Device>&)>;
    using Tell = std::function<void(const Text& sentence)>;

    // Calls `tell` with one sentence for each loss after which the work starts again. Errors: those of
    // Device::create except deviceLost, and lostTooOften.
    static Result<LastingDevice> open(Instance instance, DeviceOptions options, Tell tell);

    // Runs `use`, and runs it again on another device if its device was lost. Objects that `use` leaves on a
    // device keep that device alive, even a lost one: if `use` fails, it must leave none. Errors: those of
    // `use` and of open().
    Result<void> run(const Use& use);

  private:
    LastingDevice(Instance instance, DeviceOptions options, Tell tell);
    Result<void> ensureDevice();
    Result<void> countLoss();  // fails with lostTooOften when it was one too many

    Instance instance_;
    DeviceOptions options_;
    Tell tell_;
    LossCount losses_;
    std::shared_ptr<Device> device_;  // null before the first use, and after a loss
};

}  // namespace macula::gpu
