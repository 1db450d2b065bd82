// Memory of an image that a program made on another device object of the same card, and shares: everything
// needed to open the same image here. It outlives devices: SharedImage is that image on one of them.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "base/result.h"

namespace macula::gpu {

// An owned file descriptor. Descriptors of other owners are duplicated, so theirs stay open.
class FileDescriptor {
  public:
    FileDescriptor() = default;  // owns nothing
    // Duplicates the descriptor; child processes do not inherit the copy. Fails with usage when `descriptor`
    // is not open.
    static Result<FileDescriptor> copyOf(int descriptor);

    FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(other.release()) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~FileDescriptor();

    explicit operator bool() const { return descriptor_ >= 0; }
    int get() const { return descriptor_; }
    // Gives up ownership: the caller closes it.
    int release() { return std::exchange(descriptor_, -1); }

  private:
    explicit FileDescriptor(int owned) : descriptor_(owned) {}

    int descriptor_ = -1;
};

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
