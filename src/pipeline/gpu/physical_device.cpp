#include "pipeline/gpu/physical_device.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace macula::gpu {

bool hasExtension(VkPhysicalDevice device, const char* name) {
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(), [&](const auto& extension) {
        return std::strcmp(extension.extensionName, name) == 0;
    });
}

namespace {

std::vector<VkQueueFamilyProperties> queueFamilies(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    return families;
}

}  // namespace

bool hasCompute(VkPhysicalDevice device, std::uint32_t queueFamily) {
    const auto families = queueFamilies(device);
    return queueFamily < families.size() && (families[queueFamily].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0;
}

std::uint32_t timestampBits(VkPhysicalDevice device, std::uint32_t queueFamily) {
    return queueFamilies(device).at(queueFamily).timestampValidBits;
}

std::optional<std::uint32_t> universalQueueFamily(VkPhysicalDevice device) {
    const auto families = queueFamilies(device);
    constexpr VkQueueFlags kWanted[] = {VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT, VK_QUEUE_COMPUTE_BIT};
    for (const VkQueueFlags wanted : kWanted)
        for (std::uint32_t family = 0; family < families.size(); ++family)
            if (families[family].queueCount > 0 && (families[family].queueFlags & wanted) == wanted)
                return family;
    return std::nullopt;
}

std::uint32_t threadsAtOnce(VkPhysicalDevice device, VkPhysicalDeviceType type) {
    // Guesses for drivers that report nothing: a card of some years ago, and a GPU next to a CPU.
    constexpr std::uint32_t kDiscreteGuess = 1 << 16;
    constexpr std::uint32_t kOtherGuess = 1 << 13;
    constexpr std::uint32_t kWarp = 32;  // threads, on every card with VK_NV_shader_sm_builtins
    if (type == VK_PHYSICAL_DEVICE_TYPE_CPU) return 0;
    const auto ask = [device](auto& answer) {
        VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &answer, {}};
        vkGetPhysicalDeviceProperties2(device, &properties);
    };
    std::uint32_t threads = 0;
    if (hasExtension(device, VK_NV_SHADER_SM_BUILTINS_EXTENSION_NAME)) {
        VkPhysicalDeviceShaderSMBuiltinsPropertiesNV cores{
            VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_SM_BUILTINS_PROPERTIES_NV};
        ask(cores);
        threads = cores.shaderSMCount * cores.shaderWarpsPerSM * kWarp;
    } else if (hasExtension(device, VK_AMD_SHADER_CORE_PROPERTIES_EXTENSION_NAME)) {
        VkPhysicalDeviceShaderCorePropertiesAMD cores{
            VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_CORE_PROPERTIES_AMD};
        ask(cores);
        threads = cores.shaderEngineCount * cores.shaderArraysPerEngineCount *
                  cores.computeUnitsPerShaderArray * cores.simdPerComputeUnit * cores.wavefrontsPerSimd *
                  cores.wavefrontSize;
    }
    if (threads > 0) return threads;
    return type == VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU ? kDiscreteGuess : kOtherGuess;
}

HeapBudget deviceLocalBudget(VkPhysicalDevice device) {
    VkPhysicalDeviceMemoryBudgetPropertiesEXT budget{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT};
    VkPhysicalDeviceMemoryProperties2 memory{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2, nullptr, {}};
    const bool tellsBudget = hasExtension(device, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
    if (tellsBudget) memory.pNext = &budget;
    vkGetPhysicalDeviceMemoryProperties2(device, &memory);

    HeapBudget result;
    for (std::uint32_t heap = 0; heap < memory.memoryProperties.memoryHeapCount; ++heap) {
        const VkMemoryHeap& properties = memory.memoryProperties.memoryHeaps[heap];
        if (!(properties.flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) || properties.size <= result.bytes)
            continue;
        result.bytes = properties.size;
        result.availableBytes = properties.size;
        if (tellsBudget) {
            const std::uint64_t used = budget.heapUsage[heap];
            const std::uint64_t allowed = std::min<std::uint64_t>(budget.heapBudget[heap], properties.size);
            result.availableBytes = allowed > used ? allowed - used : 0;
        }
    }
    return result;
}

}  // namespace macula::gpu
