#include "pipeline/gpu/device_info.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "pipeline/gpu/instance_state.h"
#include "pipeline/gpu/physical_device.h"
#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

DeviceType typeOf(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return DeviceType::discrete;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return DeviceType::integrated;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return DeviceType::virtualGpu;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return DeviceType::cpu;
        default:
            return DeviceType::other;
    }
}

Text whyNotUsable(VkPhysicalDevice device, std::uint32_t apiVersion) {
    if (apiVersion < VK_API_VERSION_1_3)
        return Text("it offers Vulkan {}.{}, and 1.3 is needed", VK_API_VERSION_MAJOR(apiVersion),
                    VK_API_VERSION_MINOR(apiVersion));
    if (!hasExtension(device, VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME))
        return Text("it lacks {}", VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME);
    if (!universalQueueFamily(device)) return Text("it has no queue for compute");

    VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceVulkan12Features features12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES,
                                                &features13};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features12, {}};
    vkGetPhysicalDeviceFeatures2(device, &features);
    if (!features12.timelineSemaphore) return Text("it lacks timeline semaphores");
    if (!features12.scalarBlockLayout) return Text("it lacks scalar block layout");
    if (!features13.synchronization2) return Text("it lacks synchronization2");
    if (!features13.maintenance4) return Text("it lacks maintenance4");
    return {};
}

DeviceInfo infoOf(VkPhysicalDevice device, std::size_t index) {
    VkPhysicalDeviceProperties basic{};
    vkGetPhysicalDeviceProperties(device, &basic);

    DeviceInfo info;
    info.index = index;
    info.physical = device;
    info.name = basic.deviceName;
    info.type = typeOf(basic.deviceType);
    info.apiVersion = basic.apiVersion;
    info.maxStorageBufferBytes = basic.limits.maxStorageBufferRange;
    info.maxTexelBufferElements = basic.limits.maxTexelBufferElements;
    info.maxPushConstantBytes = basic.limits.maxPushConstantsSize;
    info.maxSharedBytes = basic.limits.maxComputeSharedMemorySize;
    info.maxGroupsX = basic.limits.maxComputeWorkGroupCount[0];
    info.maxImageEdge2D = basic.limits.maxImageDimension2D;
    info.maxImageEdge3D = basic.limits.maxImageDimension3D;
    info.whyNotUsable = whyNotUsable(device, basic.apiVersion);

    const HeapBudget budget = deviceLocalBudget(device);
    info.memoryBytes = budget.bytes;
    info.memoryAvailableBytes = budget.availableBytes;
    info.maxAllocationBytes = budget.bytes;
    if (basic.apiVersion < VK_API_VERSION_1_3) return info;  // older drivers cannot answer the rest

    VkPhysicalDeviceVulkan13Properties properties13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES};
    VkPhysicalDeviceVulkan12Properties properties12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES,
                                                    &properties13};
    VkPhysicalDeviceVulkan11Properties properties11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES,
                                                    &properties12};
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &properties11, {}};
    vkGetPhysicalDeviceProperties2(device, &properties);
    info.driver = fmt::format("{} {}", properties12.driverName, properties12.driverInfo);
    info.subgroupSize = properties11.subgroupSize;
    VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features13, {}};
    vkGetPhysicalDeviceFeatures2(device, &features);
    if (features13.subgroupSizeControl != 0 &&
        (properties13.requiredSubgroupSizeStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0) {
        info.minSubgroupSize = properties13.minSubgroupSize;
        info.maxSubgroupSize = properties13.maxSubgroupSize;
    }
    info.maxAllocationBytes =
        std::min({budget.bytes, properties11.maxMemoryAllocationSize, properties13.maxBufferSize});
    info.threadsAtOnce = threadsAtOnce(device, basic.deviceType);
    return info;
}

int rank(DeviceType type) {
    switch (type) {
        case DeviceType::discrete:
            return 0;
        case DeviceType::integrated:
            return 1;
        case DeviceType::virtualGpu:
            return 2;
        case DeviceType::cpu:
            return 3;
        case DeviceType::other:
            return 4;
    }
    return 4;
}

std::string lowerCase(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::string listed(std::span<const DeviceInfo> devices) {
    std::string list;
    for (const DeviceInfo& device : devices)
        list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", device.index, device.name);
    return list;
}

Error notUsable(const DeviceInfo& device) {
    return {ErrorCode::deviceNotUsable,
            Text("The device {} cannot be used: {}.", device.name, device.whyNotUsable), "",
            Text("Update its driver, or choose another device.")};
}

}  // namespace

std::string_view deviceTypeName(DeviceType type) {
    switch (type) {
        case DeviceType::discrete:
            return "discrete GPU";
        case DeviceType::integrated:
            return "integrated GPU";
        case DeviceType::virtualGpu:
            return "virtual GPU";
        case DeviceType::cpu:
            return "CPU";
        case DeviceType::other:
            return "other device";
    }
    return "other device";
}

std::uint32_t subgroupSizeForDivergence(const DeviceInfo& device) {
    constexpr std::uint32_t kNarrow = 32;
    return device.minSubgroupSize <= kNarrow && device.maxSubgroupSize > kNarrow ? kNarrow : 0;
}

std::string describe(const DeviceInfo& device) {
    return fmt::format("{}, {}, {}, {}", device.name, deviceTypeName(device.type),
                       bytesText(device.memoryBytes).english(), device.driver);
}

std::vector<DeviceInfo> listDevices(const Instance& instance) {
    std::uint32_t count = 0;
    if (vkEnumeratePhysicalDevices(instance.handle(), &count, nullptr) < 0) return {};
    std::vector<VkPhysicalDevice> handles(count);
    if (vkEnumeratePhysicalDevices(instance.handle(), &count, handles.data()) < 0) return {};
    handles.resize(count);

    std::vector<DeviceInfo> devices;
    for (const VkPhysicalDevice handle : handles) devices.push_back(infoOf(handle, devices.size()));
    return devices;
}

Result<DeviceInfo> chooseDevice(std::span<const DeviceInfo> devices, std::string_view preferred) {
    if (devices.empty()) return noVulkanDriver();

    if (!preferred.empty()) {
        std::size_t index = 0;
        const auto [end, status] =
            std::from_chars(preferred.data(), preferred.data() + preferred.size(), index);
        const bool isIndex = status == std::errc() && end == preferred.data() + preferred.size();
        const std::string wanted = lowerCase(preferred);

        const DeviceInfo* unusable = nullptr;
        for (const DeviceInfo& device : devices) {
            const bool named =
                isIndex ? device.index == index : lowerCase(device.name).find(wanted) != std::string::npos;
            if (named && device.usable()) return device;
            if (named && !unusable) unusable = &device;
        }
        if (unusable) return notUsable(*unusable);
        return Error{ErrorCode::usage, Text("There is no graphics device \"{}\".", preferred), "",
                     Text("Choose one by its number or a part of its name: {}", listed(devices))};
    }

    const DeviceInfo* best = nullptr;
    for (const DeviceInfo& device : devices)
        if (device.usable() && (!best || rank(device.type) < rank(best->type))) best = &device;
    if (best) return *best;
    return notUsable(devices.front());
}

}  // namespace macula::gpu
