// How a device is opened, or that of a host used.
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

// The lock of a queue that others use too. As std::mutex: held by one thread at a time, for moments; throws
// nothing.
class QueueGuard {
  public:
    QueueGuard() = default;
    QueueGuard(const QueueGuard&) = delete;
    QueueGuard& operator=(const QueueGuard&) = delete;
    virtual ~QueueGuard() = default;

    virtual void lock() = 0;
    virtual void unlock() = 0;
};

// A device that a host has made of DeviceOptions::physical and destroys after all that is made from it: with
// VK_KHR_push_descriptor, timeline semaphores, scalar block layout, synchronization2 and maintenance4.
struct LentDevice {
    VkDevice handle = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;  // with compute
    std::uint32_t queueFamily = 0;
    // Held while the queue is used; null: the host does not use it meanwhile.
    std::shared_ptr<QueueGuard> guard = nullptr;
};

struct DeviceOptions {
    std::string preferred;                // see chooseDevice; when empty, the environment MACULA_DEVICE
    std::vector<const char*> extensions;  // on top of ours: VK_KHR_SWAPCHAIN_EXTENSION_NAME for a window
    // OpenXR dictates the device (xrGetVulkanGraphicsDevice2KHR) and creates it itself
    // (xrCreateVulkanDeviceKHR).
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    std::function<VkResult(VkPhysicalDevice, const VkDeviceCreateInfo&, VkDevice*)> createDevice;
    std::optional<LentDevice> lent;  // nothing is created
    // Where the driver's compiled kernels are kept for the next start (pipeline_cache.h); made when missing.
    // Empty: no file is read or written. Never of a lent device.
    std::filesystem::path kernelsFolder;
    // Where the device is the processor, this thread and those of the driver let a window's go first
    // (give_way.h), for good. On a card a thread that submits frames must not be late.
    bool givesWay = false;
    // Takes device memory for unmapped, as on a graphics card, to test staging copies without one.
    bool separateMemory = false;
    bool isAnnounced = true;  // log::announce
};

}  // namespace macula::gpu
