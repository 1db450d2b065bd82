// Questions to a physical device. Not for users of macula::gpu: they read DeviceInfo.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <optional>

namespace macula::gpu {

bool hasExtension(VkPhysicalDevice device, const char* name);

// A family with compute and, if there is one, graphics (blits and presentation want it).
std::optional<std::uint32_t> universalQueueFamily(VkPhysicalDevice device);

// False where there is no such family, too.
bool hasCompute(VkPhysicalDevice device, std::uint32_t queueFamily);

// Valid bits of a timestamp of the family's queues; 0 when they have none.
std::uint32_t timestampBits(VkPhysicalDevice device, std::uint32_t queueFamily);

std::uint32_t threadsAtOnce(VkPhysicalDevice device, VkPhysicalDeviceType type);  // as DeviceInfo

struct HeapBudget {
    std::uint64_t bytes = 0;
    std::uint64_t availableBytes = 0;
};
HeapBudget deviceLocalBudget(VkPhysicalDevice device);  // of the largest device-local heap

}  // namespace macula::gpu
