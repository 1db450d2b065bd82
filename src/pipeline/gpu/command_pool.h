// Command buffers that are reused once the device is done with them.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <vector>

#include "pipeline/gpu/ticket.h"

namespace macula::gpu {

class CommandPool {
  public:
    static constexpr std::uint32_t kQueries = 128;  // timestamps

    struct Commands {  // of a recording, or of its part between two native kernels
        VkCommandPool pool = VK_NULL_HANDLE;
        VkCommandBuffer buffer = VK_NULL_HANDLE;
        VkQueryPool queries = VK_NULL_HANDLE;  // kQueries timestamps
        Ticket busyUntil = 0;
    };

    // Gives commands whose work is completed, or makes new ones. Returns a negative VkResult when that fails.
    VkResult take(VkDevice device, std::uint32_t queueFamily, Ticket completed, Commands& commands);
    void give(const Commands& commands) { free_.push_back(commands); }
    void destroyAll(VkDevice device);  // once the device is idle

  private:
    std::vector<Commands> free_;
};

}  // namespace macula::gpu
