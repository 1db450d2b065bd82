// Chooses a device, and opens it with the features that Macula needs. Not for users of macula::gpu: they
// create a Device.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <memory>
#include <string>

#include "base/result.h"
#include "pipeline/gpu/device_info.h"
#include "pipeline/gpu/device_options.h"
#include "pipeline/gpu/instance.h"

namespace macula::gpu {

struct OpenedDevice {
    VkDevice handle = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t queueFamily = 0;
    bool isLent = false;                // the host program destroys it
    std::shared_ptr<QueueGuard> guard;  // the lock of the host that lends the queue
};

// Fails as chooseDevice does, and with deviceNotUsable if DeviceOptions::physical is not one of the
// instance's.
Result<DeviceInfo> chosenDevice(const Instance& instance, const DeviceOptions& options);

// Fails with deviceNotUsable when an extension is missing or the driver refuses. `doing` as in vulkanError.
Result<OpenedDevice> openDevice(const DeviceInfo& info, const DeviceOptions& options, const Text& doing);
Result<OpenedDevice> borrowDevice(const LentDevice& lent, VkPhysicalDevice physical);

}  // namespace macula::gpu
