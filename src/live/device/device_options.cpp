#include "live/device/device_options.h"

#include <mutex>
#include <utility>

namespace macula::live {

namespace {

struct KernelsFolder {
    std::mutex mutex;
    std::filesystem::path folder;
};

KernelsFolder& kernelsFolder() {
    static KernelsFolder the;
    return the;
}

}  // namespace

void keepKernelsIn(std::filesystem::path folder) {
    KernelsFolder& the = kernelsFolder();
    const std::lock_guard lock(the.mutex);
    the.folder = std::move(folder);
}

gpu::DeviceOptions deviceOptions(const std::string& preferred) {
    gpu::DeviceOptions options;
    options.preferred = preferred;
    KernelsFolder& the = kernelsFolder();
    const std::lock_guard lock(the.mutex);
    options.kernelsFolder = the.folder;
    return options;
}

}  // namespace macula::live
