#include "pipeline/gpu/device_opening.h"

#include <cstdlib>
#include <span>

#include "base/give_way.h"
#include "pipeline/gpu/physical_device.h"
#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {

namespace {

struct FeatureChain {
    VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &v13};
    VkPhysicalDeviceVulkan11Features v11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES, &v12};
    VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &v11, {}};

    FeatureChain() = default;
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;
};

// Macula's required features, which listDevices has checked, and those of its optional ones that the device
// has.
struct Features : FeatureChain {
    explicit Features(VkPhysicalDevice device) {
        FeatureChain offered;
        vkGetPhysicalDeviceFeatures2(device, &offered.core);
        core.features.shaderStorageImageReadWithoutFormat =
            offered.core.features.shaderStorageImageReadWithoutFormat;
        core.features.shaderStorageImageWriteWithoutFormat =
            offered.core.features.shaderStorageImageWriteWithoutFormat;
        v12.timelineSemaphore = VK_TRUE;
        v12.scalarBlockLayout = VK_TRUE;
        v13.synchronization2 = VK_TRUE;
        v13.maintenance4 = VK_TRUE;
        v13.subgroupSizeControl = offered.v13.subgroupSizeControl;
        v13.computeFullSubgroups = offered.v13.computeFullSubgroups;
    }
};

}  // namespace

Result<DeviceInfo> chosenDevice(const Instance& instance, const DeviceOptions& options) {
    const auto devices = listDevices(instance);
    if (options.physical != VK_NULL_HANDLE) {
        for (const DeviceInfo& device : devices)
            if (device.physical == options.physical) return chooseDevice(std::span(&device, 1), "");
        if (options.lent)
            return Error{ErrorCode::deviceNotUsable,
                         Text("The graphics device that was lent is not one of its VkInstance."), "",
                         Text("Give the VkInstance and the VkPhysicalDevice that the device was made of.")};
        return Error{ErrorCode::deviceNotUsable,
                     Text("The headset asks for a graphics device that is not there."), "",
                     Text("Restart the headset's software.")};
    }
    const char* environment = std::getenv("MACULA_DEVICE");
    const std::string preferred =
        !options.preferred.empty() ? options.preferred : std::string(environment ? environment : "");
    return chooseDevice(devices, preferred);
}

Result<OpenedDevice> borrowDevice(const LentDevice& lent, VkPhysicalDevice physical) {
    if (!lent.handle || !lent.queue || !physical)
        return Error{ErrorCode::deviceNotUsable, Text("The program that lends a graphics device gave none."),
                     "", Text("Give a device, a queue of it, and what it was made of.")};
    if (!hasCompute(physical, lent.queueFamily))
        return Error{ErrorCode::usage, Text("The queue that was lent is of a family that cannot compute."),
                     "", Text("Give a queue with compute, and the number of its family.")};
    return OpenedDevice{lent.handle, lent.queue, lent.queueFamily, true, lent.guard};
}

Result<OpenedDevice> openDevice(const DeviceInfo& info, const DeviceOptions& options, const Text& doing) {
    OpenedDevice opened{.queueFamily = *universalQueueFamily(info.physical)};
    std::vector<const char*> extensions = options.extensions;
    extensions.push_back(VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME);
    for (const char* extension : extensions)
        if (!hasExtension(info.physical, extension))
            return Error{ErrorCode::deviceNotUsable,
                         Text("The device {} does not offer {}.", info.name, extension), "",
                         Text("Update its driver, or choose another device with MACULA_DEVICE.")};
    // Optional: for memoryAvailableBytes, and for images that other devices share (shared_image.h).
    for (const char* extension :
         {VK_EXT_MEMORY_BUDGET_EXTENSION_NAME, VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME,
          VK_KHR_EXTERNAL_SEMAPHORE_FD_EXTENSION_NAME})
        if (hasExtension(info.physical, extension)) extensions.push_back(extension);

    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queueInfo{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queueInfo.queueFamilyIndex = opened.queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;

    const Features features(info.physical);
    VkDeviceCreateInfo deviceInfo{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features.core};
    deviceInfo.queueCreateInfoCount = 1;
    deviceInfo.pQueueCreateInfos = &queueInfo;
    deviceInfo.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    deviceInfo.ppEnabledExtensionNames = extensions.data();
    if (options.givesWay && info.type == DeviceType::cpu) giveWay(GiveWay::toTheFrame);
    MACULA_VK_TRY(options.createDevice ? options.createDevice(info.physical, deviceInfo, &opened.handle)
                                       : vkCreateDevice(info.physical, &deviceInfo, nullptr, &opened.handle),
                  doing);
    vkGetDeviceQueue(opened.handle, opened.queueFamily, 0, &opened.queue);
    return opened;
}

}  // namespace macula::gpu
