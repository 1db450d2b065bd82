// What devices there are, and which one to use.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/instance.h"

namespace macula::gpu {

enum class DeviceType { discrete, integrated, virtualGpu, cpu, other };

std::string_view deviceTypeName(DeviceType type);  // "discrete GPU", "CPU", ...

struct DeviceInfo {
    std::size_t index = 0;  // position in listDevices
    std::string name;
    DeviceType type = DeviceType::other;
    std::string driver;  // name and version: "llvmpipe, Mesa 22.3.6 (LLVM 15.0.6)"
    std::uint32_t apiVersion = 0;

    std::uint64_t memoryBytes = 0;  // the largest device-local heap
    std::uint64_t memoryAvailableBytes =
        0;  // of that heap, by VK_EXT_memory_budget when asked; else memoryBytes
    std::uint64_t maxAllocationBytes = 0;  // of one buffer or image
    std::uint32_t maxStorageBufferBytes = 0;
    std::uint32_t maxTexelBufferElements = 0;
    std::uint32_t maxPushConstantBytes = 0;
    std::uint32_t maxSharedBytes = 0;  // of the threads of a group
    std::uint32_t maxImageEdge2D = 0;
    std::uint32_t maxImageEdge3D = 0;
    std::uint32_t subgroupSize = 0;  // of kernels that require none; where the driver may choose, the largest
    std::uint32_t minSubgroupSize = 0;  // what KernelOptions::subgroupSize may require; 0: nothing
    std::uint32_t maxSubgroupSize = 0;
    std::uint32_t maxGroupsX = 0;  // of one dispatch
    // That it can hold at a time, so that each core has others to turn to while one waits for memory; by the
    // driver where it tells, else a guess by the type. 0 on CPU devices, which hold as many as they have
    // lanes.
    std::uint32_t threadsAtOnce = 0;

    Text whyNotUsable;  // empty when usable; else what it lacks: "Vulkan 1.3"
    VkPhysicalDevice physical = VK_NULL_HANDLE;

    bool usable() const { return whyNotUsable.empty(); }
};

// The subgroup size to require (KernelOptions) of kernels whose threads part ways, as paths do: 32 where the
// driver would choose more and 32 can be had, as on AMD's cards; else 0, what the driver chooses.
std::uint32_t subgroupSizeForDivergence(const DeviceInfo& device);

// One line for people: "llvmpipe (LLVM 15.0.6, 256 bits), CPU, 2.0 GiB, llvmpipe Mesa 22.3.6".
std::string describe(const DeviceInfo& device);

// All devices in the driver's order; an unusable one has the reason in whyNotUsable. Empty when there is no
// driver.
std::vector<DeviceInfo> listDevices(const Instance& instance);

// The device to use: the first usable one of the best type (discrete, integrated, virtual, CPU), or the one
// `preferred` names by index ("1") or by a part of its name, in any case ("llvmpipe"; the first usable one
// that has it). Pure. usage when nothing has that name (the hint lists what there is), deviceNotUsable when
// there is no device, the preferred one is not usable, or none is.
Result<DeviceInfo> chooseDevice(std::span<const DeviceInfo> devices, std::string_view preferred);

}  // namespace macula::gpu
