#include "pipeline/gpu/recovery.h"

#include <utility>

namespace macula::gpu {

bool LossCount::mayGoOn(Clock::time_point now) {
    lately_.push_back(now);
    while (now - lately_.front() >= kLossWindow) lately_.pop_front();
    return lately_.size() < static_cast<std::size_t>(kMostLosses);
}

Error lostTooOften() {
    return {
        ErrorCode::deviceLost,
        Text("The graphics device stopped responding {} times within a minute.", kMostLosses), "",
        Text("Update the graphics driver, or choose another device: `macula devices` lists them, --device or "
             "MACULA_DEVICE takes one. The processor (llvmpipe) is slow but always there.")};
}

LastingDevice::LastingDevice(Instance instance, DeviceOptions options, Tell tell)
    : instance_(std::move(instance)), options_(std::move(options)), tell_(std::move(tell)) {}

Result<LastingDevice> LastingDevice::open(Instance instance, DeviceOptions options, Tell tell) {
    LastingDevice lasting(std::move(instance), std::move(options), std::move(tell));
    MACULA_TRY_VOID(lasting.ensureDevice());
    return lasting;
}

Result<void> LastingDevice::ensureDevice() {
    while (!device_) {
        Result<std::shared_ptr<Device>> made = Device::create(instance_, options_);
        if (made.ok()) {
            device_ = *std::move(made);
        } else if (made.error().code != ErrorCode::deviceLost) {
            return made.error();
        } else {
            MACULA_TRY_VOID(countLoss());
        }
    }
    return {};
}

Result<void> LastingDevice::countLoss() {
    device_.reset();  // some drivers allow no new device before the old one is gone
    if (!losses_.mayGoOn()) return lostTooOften();
    tell_(Text("The graphics device stopped responding; the work begins anew on a new one."));
    return {};
}

Result<void> LastingDevice::run(const Use& use) {
    while (true) {
        MACULA_TRY_VOID(ensureDevice());
        Result<void> done = use(device_);
        if (done.ok() || !device_->lost()) return done;
        MACULA_TRY_VOID(countLoss());
    }
}

}  // namespace macula::gpu
