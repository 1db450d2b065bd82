// Host memory for copies to and from a device, kept for the next copies: on a graphics card, allocating it
// takes longer than the copy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"

namespace macula::gpu {

// Belongs to a device, and therefore holds bare Vulkan objects: a Buffer would keep its device alive. Used by
// the thread that uses the device.
class StagingPool {
  public:
    static constexpr std::size_t kMostOfAKind = 4;
    static constexpr std::uint64_t kMostBytes = 16u << 20;   // the largest buffer that is kept
    static constexpr std::uint64_t kLeastBytes = 64u << 10;  // sizes of kept buffers are multiples of it

    // A buffer of at least `bytes` bytes that no submitted work uses. `kind` is upload or readback.
    Result<Buffer> take(const std::shared_ptr<Device>& device, MemoryKind kind, std::uint64_t bytes);
    // The same; when memory is short, a smaller buffer, of at least kLeastBytes or `bytes`.
    Result<Buffer> takeUpTo(const std::shared_ptr<Device>& device, MemoryKind kind, std::uint64_t bytes);
    // The buffer is reused only when all work submitted so far is done. Of more than kMostOfAKind buffers of
    // a kind, the smallest is freed.
    void giveBack(Buffer buffer, MemoryKind kind);
    // Frees the kept buffers, each as soon as no work uses it.
    void clear(const std::shared_ptr<Device>& device);
    // Call when the device is idle and about to be destroyed.
    void destroyAll(VkDevice device);

    std::size_t kept() const { return kept_.size(); }
    std::uint64_t made() const { return made_; }  // buffers allocated since the device was opened

  private:
    struct Kept {
        VkBuffer buffer = VK_NULL_HANDLE;
        VkDeviceMemory memory = VK_NULL_HANDLE;
        std::string label;
        std::uint64_t bytes = 0;
        VkBufferUsageFlags usage = 0;
        std::span<std::byte> mapped;
        bool hostCached = false;
        MemoryKind kind = MemoryKind::upload;
        Ticket busyUntil = 0;
    };
    Buffer taken(const std::shared_ptr<Device>& device, std::vector<Kept>::iterator kept);
    static Buffer owned(const std::shared_ptr<Device>& device, const Kept& kept);

    std::vector<Kept> kept_;
    std::uint64_t made_ = 0;
};

// A staging buffer that is given back to the pool at the end of its scope.
class Staging {
  public:
    static Result<Staging> take(const std::shared_ptr<Device>& device, MemoryKind kind, std::uint64_t bytes);
    static Result<Staging> takeUpTo(const std::shared_ptr<Device>& device, MemoryKind kind,
                                    std::uint64_t bytes);

    Staging(Staging&&) noexcept = default;
    Staging& operator=(Staging&&) = delete;
    ~Staging();

    const Buffer& buffer() const { return buffer_; }
    std::byte* data() const { return buffer_.mapped().data(); }

  private:
    Staging(Buffer buffer, MemoryKind kind) : buffer_(std::move(buffer)), kind_(kind) {}

    Buffer buffer_;
    MemoryKind kind_;
};

}  // namespace macula::gpu
