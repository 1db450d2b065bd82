// Lists the devices of this computer, and chooses one.
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
        0;  // of that heap, by VK_EXT_memory_budget if the device has it; else memoryBytes
    std::uint64_t maxAllocationBytes = 0;  // of one buffer or image
    std::uint32_t maxStorageBufferBytes = 0;
    std::uint32_t maxTexelBufferElements = 0;
    std::uint32_t maxPushConstantBytes = 0;
    std::uint32_t maxSharedBytes = 0;  // shared by the threads of a workgroup
    std::uint32_t maxImageEdge2D = 0;
    std::uint32_t maxImageEdge3D = 0;
    std::uint32_t subgroupSize = 0;  // of kernels that require no size; if the driver may choose, the largest
    std::uint32_t minSubgroupSize = 0;  // the least that KernelOptions::subgroupSize may require; 0: nothing
    std::uint32_t maxSubgroupSize = 0;
    std::uint32_t maxGroupsX = 0;  // of one dispatch
    // How many threads the device holds at a time: enough for each core to switch to others while one waits
    // for memory. Reported by the driver, else guessed from the type. 0 on CPU devices, which hold as many
    // threads as they have SIMD lanes.
    std::uint32_t threadsAtOnce = 0;

    Text whyNotUsable;  // empty when usable; else the reason: "it lacks maintenance4"
    VkPhysicalDevice physical = VK_NULL_HANDLE;

    bool usable() const { return whyNotUsable.empty(); }
};

// The subgroup size to require (KernelOptions) for kernels whose threads diverge, as light paths do: 32 if
// the driver would choose more and allows 32, as on AMD's cards; else 0, which leaves the choice to the
// driver.
std::uint32_t subgroupSizeForDivergence(const DeviceInfo& device);

// One line for people: "llvmpipe (LLVM 15.0.6, 256 bits), CPU, 2.0 GiB, llvmpipe Mesa 22.3.6".
std::string describe(const DeviceInfo& device);

// All devices in the driver's order; for an unusable one whyNotUsable says why. Empty when there is no
// driver.
std::vector<DeviceInfo> listDevices(const Instance& instance);

// The device to use: the first usable one of the best type (discrete, integrated, virtual, CPU), or the one
// that `preferred` names by index ("1") or by a part of its name, in any case ("llvmpipe": the first usable
// device whose name contains it). Pure. Fails with usage when no device has that name (the hint lists all);
// with deviceNotUsable when there is no device, the preferred one is not usable, or none is.
Result<DeviceInfo> chooseDevice(std::span<const DeviceInfo> devices, std::string_view preferred);

}  // namespace macula::gpu
