// What a program lends that has a Vulkan device of its own, without a header of Vulkan: src/c.
#pragma once

#include <cstdint>
#include <functional>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"

namespace macula::app {

// How a device is opened, as often as one is wanted: each has an instance of its own, or shares what is lent.
struct DeviceWay {
    gpu::InstanceOptions instance;
    gpu::DeviceOptions device;
};

// Handles of Vulkan as pointers; see gpu::LentDevice for what they must have.
struct LentHandles {
    void* instance = nullptr;
    void* physical = nullptr;
    void* device = nullptr;
    void* queue = nullptr;
    std::uint32_t queueFamily = 0;
    // Called around each use of the queue; both, or neither: then copies of the
    // DeviceWay share a lock of their own. They throw nothing.
    std::function<void()> lock = {};
    std::function<void()> unlock = {};
};

// usage when a handle is missing, or one of the two functions.
Result<DeviceWay> lentWay(const LentHandles& lent);

// An image on such a device, with VK_IMAGE_USAGE_TRANSFER_DST_BIT and texels of R8G8B8A8.
struct LentPicture {
    std::uint64_t image = 0;  // VkImage
    std::uint32_t layer = 0;
    std::int32_t layout = 0;  // VkImageLayout that it is left in; 0: VK_IMAGE_LAYOUT_GENERAL
};

}  // namespace macula::app
