// Memory of an image that a program made on another device object of the same card, and shares: everything
// needed to open the same image here. It outlives devices: SharedImage is that image on one of them.
#pragma once

#include <array>
#include <cstdint>

#include "base/result.h"
#include "pipeline/gpu/file_descriptor.h"

namespace macula::gpu {

class Device;

// Identifies a card and its driver for every program: VkPhysicalDeviceIDProperties.
struct CardIdentity {
    std::array<std::uint8_t, 16> device{};
    std::array<std::uint8_t, 16> driver{};

    bool operator==(const CardIdentity&) const = default;
};
CardIdentity identityOf(const Device& device);

// How the other program made the memory and the image. Plain numbers: none is used as a Vulkan enumerator
// before it is checked.
struct SharedMemoryHandles {
    // Opaque file descriptors of VkDeviceMemory and of binary VkSemaphores; 0 and below: none.
    int memory = 0;
    int wait = 0;    // awaited before the image is written
    int signal = 0;  // signalled when the image is written
    CardIdentity card;
    std::uint64_t bytes = 0;        // size of the allocation
    std::uint64_t offsetBytes = 0;  // where the image begins in the allocation
    std::uint32_t memoryType = 0;   // index of the memory type
    bool isDedicated = false;       // allocated with VkMemoryDedicatedAllocateInfo
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t format = 0;  // VkFormat: R8G8B8A8, UNORM or SRGB
    std::uint32_t tiling = 0;  // VkImageTiling
    std::uint32_t usage = 0;   // VkImageUsageFlags, including VK_IMAGE_USAGE_TRANSFER_DST_BIT
    std::uint32_t flags = 0;   // VkImageCreateFlags
    std::uint32_t layout = 0;  // VkImageLayout in which the image is left; 0: VK_IMAGE_LAYOUT_GENERAL
};

class SharedMemory {
  public:
    // Duplicates the descriptors. Fails with usage when something is missing, or cannot belong to an image.
    static Result<SharedMemory> create(const SharedMemoryHandles& options);

    // Checked. Its descriptors are those of the other program, which may have closed them by now.
    const SharedMemoryHandles& options() const { return options_; }
    const FileDescriptor& memory() const { return memory_; }
    const FileDescriptor& wait() const { return wait_; }      // may be none
    const FileDescriptor& signal() const { return signal_; }  // may be none

  private:
    SharedMemory() = default;

    SharedMemoryHandles options_;
    FileDescriptor memory_;
    FileDescriptor wait_;
    FileDescriptor signal_;
};

}  // namespace macula::gpu
