// Queries of a physical device. Not for users of macula::gpu: they read DeviceInfo.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <optional>

namespace macula::gpu {

bool hasExtension(VkPhysicalDevice device, const char* name);

// A queue family with compute and, if possible, graphics, which blits and presentation need.
std::optional<std::uint32_t> universalQueueFamily(VkPhysicalDevice device);

// Also false if there is no such family.
bool hasCompute(VkPhysicalDevice device, std::uint32_t queueFamily);

// The number of valid bits in the timestamps of the family's queues; 0 without timestamps.
std::uint32_t timestampBits(VkPhysicalDevice device, std::uint32_t queueFamily);

std::uint32_t threadsAtOnce(VkPhysicalDevice device, VkPhysicalDeviceType type);  // see DeviceInfo

struct HeapBudget {
    std::uint64_t bytes = 0;
    std::uint64_t availableBytes = 0;
};
HeapBudget deviceLocalBudget(VkPhysicalDevice device);  // of the largest device-local heap

}  // namespace macula::gpu
