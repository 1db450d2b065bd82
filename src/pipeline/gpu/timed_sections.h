// The sections of a recording whose time the device measures.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/gpu/command_pool.h"

namespace macula::gpu {

struct Timing {
    std::string name;
    double milliseconds = 0.0;
};

// Two timestamps of a VkQueryPool for each section; sections may contain others, and begin and end in
// different command buffers of one queue.
class TimedSections {
  public:
    static constexpr int kMost = CommandPool::kQueries / 2;

    TimedSections() = default;
    explicit TimedSections(VkQueryPool queries) : queries_(queries) {}

    // Returns the number of the section. At most kMost.
    int begin(VkCommandBuffer commands, std::string_view name);
    void end(VkCommandBuffer commands, int section) const;

    // In the order of their begins, once the work is done. Timestamps have this many valid bits.
    VkResult read(VkDevice device, std::uint32_t validBits, double periodNs,
                  std::vector<Timing>& timings) const;

  private:
    VkQueryPool queries_ = VK_NULL_HANDLE;
    std::vector<std::string> names_;
};

}  // namespace macula::gpu
