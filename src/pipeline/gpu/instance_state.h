// The state that an Instance shares with the devices made from it. Not for users of macula::gpu.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "pipeline/gpu/instance.h"

namespace macula::gpu {

struct ValidationMessages {
    std::mutex mutex;  // the layer calls back on whichever thread made the mistake
    std::vector<std::string> texts;
};

struct Instance::State {
    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State();

    VkInstance handle = VK_NULL_HANDLE;
    bool isLent = false;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    bool validating = false;
    bool debugUtils = false;
    ValidationMessages messages;
};

Error noVulkanDriver();

}  // namespace macula::gpu
