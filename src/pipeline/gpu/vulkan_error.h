// Turns a VkResult into an error for a person.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string_view>

#include "base/result.h"

namespace macula::gpu {

// The enumerator, for the log: "VK_ERROR_DEVICE_LOST".
std::string_view vkResultName(VkResult result);

// `doing` completes "Could not ...": "create the buffer 'volume' of 2.0 GiB". Lack of memory becomes
// outOfMemory, a lost device deviceLost, everything else deviceNotUsable.
Error vulkanError(VkResult result, const Text& doing);

// "512 bytes", "16.0 KiB", "1.5 GiB".
Text bytesText(std::uint64_t bytes);

}  // namespace macula::gpu

// Returns the Error from the enclosing function when a Vulkan call fails.
#define MACULA_VK_TRY(call, doing)                                                        \
    do {                                                                                  \
        const VkResult maculaVkResult = (call);                                           \
        if (maculaVkResult < 0) return ::macula::gpu::vulkanError(maculaVkResult, doing); \
    } while (false)
