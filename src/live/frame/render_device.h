// The device of a renderer with the tracer on it, and how often it was lost.
#pragma once

#include <memory>
#include <optional>

#include "base/result.h"
#include "live/frame/screen.h"
#include "live/frame/traced_pictures.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"
#include "pipeline/gpu/recovery.h"

namespace macula::live {

// Used by the render thread alone. Drop everything that is on the device before drop() is called, and before
// this is destroyed: otherwise the device lives as long as the last of it.
class RenderDevice {
  public:
    // `options` says which device to open, or lends one.
    RenderDevice(gpu::Instance instance, gpu::DeviceOptions options);

    // Opens the device, with the extensions of `place`, unless it is open, and makes the tracer. If the
    // tracer fails, the device stays open.
    Result<void> open(const ScreenPlace& place);
    bool isOpen() const { return device_ != nullptr; }
    bool isReady() const { return device_ && traced_; }
    // Drops the tracer, and then the device.
    void drop();

    // False without a device: one that was lost while it was being created is not there.
    bool isLost() const { return device_ && device_->lost(); }
    // Counts a loss. False if it was one too many.
    bool mayGoOnAfterLoss() { return losses_.mayGoOn(); }

    // Null while it is not open.
    const std::shared_ptr<gpu::Device>& device() const { return device_; }
    // Null until open() has made the tracer; the address stays valid until drop().
    TracedPictures* traced() { return traced_ ? &*traced_ : nullptr; }

  private:
    gpu::Instance instance_;
    gpu::DeviceOptions options_;
    std::shared_ptr<gpu::Device> device_;
    std::optional<TracedPictures> traced_;  // after the device, because it is destroyed first
    gpu::LossCount losses_;
};

}  // namespace macula::live
