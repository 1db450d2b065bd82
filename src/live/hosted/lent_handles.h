// What a program with its own Vulkan device lends to Macula. Includes no Vulkan header, for src/c.
#pragma once

#include <cstdint>
#include <functional>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"

namespace macula::live {

// How to open a device, any number of times: each opening makes its own instance, or shares the lent one.
struct DeviceWay {
    gpu::InstanceOptions instance;
    gpu::DeviceOptions device;
};

// Vulkan handles as pointers; gpu::LentDevice says what they must support.
struct LentHandles {
    void* instance = nullptr;
    void* physical = nullptr;
    void* device = nullptr;
    void* queue = nullptr;
    std::uint32_t queueFamily = 0;
    // Called around each use of the queue. Give both or neither: without them, copies of the DeviceWay share
    // a lock of their own. They must not throw.
    std::function<void()> lock = {};
    std::function<void()> unlock = {};
};

// Fails with usage if a handle, or one of the two functions, is missing.
Result<DeviceWay> lentWay(const LentHandles& lent);

// An image on such a device, with VK_IMAGE_USAGE_TRANSFER_DST_BIT and texels of R8G8B8A8.
struct LentPicture {
    std::uint64_t image = 0;  // VkImage
    std::uint32_t layer = 0;
    std::int32_t layout = 0;  // final VkImageLayout; 0: VK_IMAGE_LAYOUT_GENERAL
};

}  // namespace macula::live
