#include "app/open_device.h"

#include <utility>

namespace macula::app {

Result<gpu::LastingDevice> openDevice(const std::string& preferred, gpu::LastingDevice::Tell tell) {
    MACULA_TRY(gpu::Instance instance, gpu::Instance::create());
    gpu::DeviceOptions options;
    options.preferred = preferred;
    return gpu::LastingDevice::open(std::move(instance), options, std::move(tell));
}

}  // namespace macula::app
