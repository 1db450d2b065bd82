// XR_KHR_vulkan_enable2: instance and device are made here, from what the application asks for.
#include "xr/runtime/state.h"

namespace macula::xr_script {

namespace {

XrResult XRAPI_CALL requirements(XrInstance, XrSystemId, XrGraphicsRequirementsVulkan2KHR* requirements) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = entered("xrGetVulkanGraphicsRequirements2KHR"); lost != XR_SUCCESS) return lost;
    const bool isNewer = state().script.needsNewerVulkan;
    requirements->minApiVersionSupported = XR_MAKE_VERSION(isNewer ? 2 : 1, 0, 0);
    requirements->maxApiVersionSupported = XR_MAKE_VERSION(isNewer ? 2 : 1, 3, 0xffff);
    state().requirementsAsked = true;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createVulkanInstance(XrInstance, const XrVulkanInstanceCreateInfoKHR* info,
                                         VkInstance* instance, VkResult* result) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = entered("xrCreateVulkanInstanceKHR"); lost != XR_SUCCESS) return lost;
    if (info->type != XR_TYPE_VULKAN_INSTANCE_CREATE_INFO_KHR || !info->pfnGetInstanceProcAddr ||
        !info->vulkanCreateInfo)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrCreateVulkanInstanceKHR: the structure");
    if (!s.requirementsAsked)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrCreateVulkanInstanceKHR before the requirements");
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(
        info->pfnGetInstanceProcAddr(VK_NULL_HANDLE, "vkCreateInstance"));
    *result = create(info->vulkanCreateInfo, info->vulkanAllocator, instance);
    if (*result == VK_SUCCESS) {
        s.vulkan = *instance;
        s.vulkanProcAddr = info->pfnGetInstanceProcAddr;
    }
    return XR_SUCCESS;
}

VkPhysicalDevice firstDevice(VkInstance instance) {
    std::uint32_t count = 1;
    VkPhysicalDevice device = VK_NULL_HANDLE;
    vkEnumeratePhysicalDevices(instance, &count, &device);
    return device;
}

XrResult XRAPI_CALL graphicsDevice(XrInstance, const XrVulkanGraphicsDeviceGetInfoKHR* info,
                                   VkPhysicalDevice* device) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = entered("xrGetVulkanGraphicsDevice2KHR"); lost != XR_SUCCESS) return lost;
    if (info->vulkanInstance != state().vulkan)
        return wrong(XR_ERROR_HANDLE_INVALID, "xrGetVulkanGraphicsDevice2KHR: another VkInstance");
    *device = firstDevice(info->vulkanInstance);
    return *device ? XR_SUCCESS : XR_ERROR_RUNTIME_FAILURE;
}

XrResult XRAPI_CALL createVulkanDevice(XrInstance, const XrVulkanDeviceCreateInfoKHR* info, VkDevice* device,
                                       VkResult* result) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = entered("xrCreateVulkanDeviceKHR"); lost != XR_SUCCESS) return lost;
    if (info->type != XR_TYPE_VULKAN_DEVICE_CREATE_INFO_KHR || info->createFlags != 0 ||
        !info->pfnGetInstanceProcAddr || !info->vulkanCreateInfo)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrCreateVulkanDeviceKHR: the structure");
    if (!s.vulkan || info->vulkanPhysicalDevice != firstDevice(s.vulkan))
        return wrong(XR_ERROR_HANDLE_INVALID, "xrCreateVulkanDeviceKHR: another VkPhysicalDevice");
    const auto create =
        reinterpret_cast<PFN_vkCreateDevice>(info->pfnGetInstanceProcAddr(s.vulkan, "vkCreateDevice"));
    *result = create(info->vulkanPhysicalDevice, info->vulkanCreateInfo, info->vulkanAllocator, device);
    return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction vulkanFunction(std::string_view name) {
    if (!state().extensions.contains(XR_KHR_VULKAN_ENABLE2_EXTENSION_NAME)) return nullptr;
    if (name == "xrGetVulkanGraphicsRequirements2KHR")
        return reinterpret_cast<PFN_xrVoidFunction>(requirements);
    if (name == "xrCreateVulkanInstanceKHR")
        return reinterpret_cast<PFN_xrVoidFunction>(createVulkanInstance);
    if (name == "xrGetVulkanGraphicsDevice2KHR") return reinterpret_cast<PFN_xrVoidFunction>(graphicsDevice);
    if (name == "xrCreateVulkanDeviceKHR") return reinterpret_cast<PFN_xrVoidFunction>(createVulkanDevice);
    return nullptr;
}

}  // namespace macula::xr_script
