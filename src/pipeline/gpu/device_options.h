// How to open a device, or use that of a host program.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace macula::gpu {

// The lock of a queue that others use too. Works like std::mutex: one thread at a time holds it, briefly; its
// functions must not throw.
class QueueGuard {
  public:
    QueueGuard() = default;
    QueueGuard(const QueueGuard&) = delete;
    QueueGuard& operator=(const QueueGuard&) = delete;
    virtual ~QueueGuard() = default;

    virtual void lock() = 0;
    virtual void unlock() = 0;
};

// A device that a host program has made from DeviceOptions::physical, and destroys after everything that is
// made from it. It must have VK_KHR_push_descriptor, timeline semaphores, scalar block layout,
// synchronization2 and maintenance4.
struct LentDevice {
    VkDevice handle = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;  // must support compute
    std::uint32_t queueFamily = 0;
    // Held while Macula uses the queue. Null: the host does not use the queue at the same time.
    std::shared_ptr<QueueGuard> guard = nullptr;
};

struct DeviceOptions {
    std::string preferred;                // see chooseDevice; when empty, the environment MACULA_DEVICE
    std::vector<const char*> extensions;  // besides Macula's: VK_KHR_SWAPCHAIN_EXTENSION_NAME for a window
    // OpenXR dictates the device (xrGetVulkanGraphicsDevice2KHR) and creates it itself
    // (xrCreateVulkanDeviceKHR).
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    std::function<VkResult(VkPhysicalDevice, const VkDeviceCreateInfo&, VkDevice*)> createDevice;
    std::optional<LentDevice> lent;  // used instead of creating a device
    // The folder that keeps the driver's compiled kernels for the next start (pipeline_cache.h); made if
    // missing. Empty: no file is read or written. Ignored for a lent device.
    std::filesystem::path kernelsFolder;
    // If the device is the CPU, lowers the priority of this thread and of the driver's threads for good
    // (give_way.h), so that a window stays responsive. Has no effect on a graphics card, where a thread that
    // submits frames must not be late.
    bool givesWay = false;
    // Treats device memory as unmapped, as on a graphics card, to test staging copies without one.
    bool separateMemory = false;
    // Whether kernels that have a twin on the host (native_kernel.h) run there, if the device is the CPU. The
    // environment MACULA_NATIVE_KERNELS=off forbids it, to compare both.
    bool nativeKernels = true;
    bool isAnnounced = true;  // log the device by log::announce
};

}  // namespace macula::gpu
