#include "live/frame/render_device.h"

#include <utility>

namespace macula::live {

RenderDevice::RenderDevice(gpu::Instance instance, gpu::DeviceOptions options)
    : instance_(std::move(instance)), options_(std::move(options)) {}

Result<void> RenderDevice::open(const ScreenPlace& place) {
    if (!device_) {
        gpu::DeviceOptions options = options_;
        for (const char* extension : place.deviceExtensions()) options.extensions.push_back(extension);
        MACULA_TRY(device_, gpu::Device::create(instance_, options));
    }
    MACULA_TRY(traced_, TracedPictures::create(device_));
    return {};
}

void RenderDevice::drop() {
    traced_.reset();
    device_.reset();
}

}  // namespace macula::live
