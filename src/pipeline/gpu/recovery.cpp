#include "pipeline/gpu/recovery.h"

#include <utility>

namespace macula::gpu {

bool LossCount::mayGoOn(Clock::time_point now) {
    lately_.push_back(now);
    while (now - lately_.front() >= kLossWindow) lately_.pop_front();
    return lately_.size() < static_cast<std::size_t>(kMostLosses);
}

Error lostTooOften() {
    return {ErrorCode::deviceLost,
            fmt::format("The graphics device stopped responding {} times within a minute.", kMostLosses), "",
            "Update the graphics driver, or choose another device: `macula devices` lists them, --device or "
            "MACULA_DEVICE takes one. The processor (llvmpipe) is slow but always there."};
}

LastingDevice::LastingDevice(Instance instance, DeviceOptions options, Tell tell,
                             std::shared_ptr<Device> device)
    : instance_(std::move(instance)),
      options_(std::move(options)),
      tell_(std::move(tell)),
      device_(std::move(device)) {}

Result<LastingDevice> LastingDevice::open(Instance instance, DeviceOptions options, Tell tell) {
    MACULA_TRY(std::shared_ptr<Device> device, Device::create(instance, options));
    return LastingDevice(std::move(instance), std::move(options), std::move(tell), std::move(device));
}

Result<void> LastingDevice::run(const Use& use) {
    while (true) {
        if (!device_) {
            MACULA_TRY(device_, Device::create(instance_, options_));
        }
        Result<void> done = use(device_);
        if (done.ok() || !device_->lost()) return done;
        if (!losses_.mayGoOn()) return lostTooOften();
        tell_("The graphics device stopped responding; the work begins anew on a new one.");
        device_.reset();  // first: some drivers allow no new one before the old one is gone
    }
}

}  // namespace macula::gpu
