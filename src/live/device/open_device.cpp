#include "live/device/open_device.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>
#include <mutex>
#include <utility>

namespace macula::live {

namespace {

namespace fs = std::filesystem;

struct KernelsFolder {
    std::mutex mutex;
    std::filesystem::path folder;
};

KernelsFolder& kernelsFolder() {
    static KernelsFolder the;
    return the;
}

}  // namespace

fs::path usualKernelsFolder() {
    if (const char* chosen = std::getenv("MACULA_KERNELS"); chosen != nullptr) return chosen;
    const fs::path below = fs::path("macula") / "kernels";
    // The XDG specification has programs ignore a relative path.
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && fs::path(cache).is_absolute())
        return cache / below;
    const char* home = std::getenv("HOME");
    if (home == nullptr || *home == '\0') {
        const passwd* user = getpwuid(geteuid());
        home = user != nullptr ? user->pw_dir : nullptr;
    }
    return home != nullptr && fs::path(home).is_absolute() ? home / (".cache" / below) : fs::path();
}

Result<gpu::LastingDevice> openDevice(const std::string& preferred, gpu::LastingDevice::Tell tell) {
    MACULA_TRY(gpu::Instance instance, gpu::Instance::create());
    return gpu::LastingDevice::open(std::move(instance), deviceOptions(preferred), std::move(tell));
}

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
