#include "cli/open_device.h"

#include "cli/report.h"

namespace macula::cli {

Result<gpu::LastingDevice> openDevice(const std::string& preferred) {
    MACULA_TRY(gpu::Instance instance, gpu::Instance::create());
    gpu::DeviceOptions options;
    options.preferred = preferred;
    return gpu::LastingDevice::open(std::move(instance), options, printNote);
}

}  // namespace macula::cli
