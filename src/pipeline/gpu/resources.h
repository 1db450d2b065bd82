// Buffers, images and samplers: move-only values, each with a memory allocation of its own.
//
// All may be dropped at any time, on any thread, also while the GPU uses them. Creation fails with
// outOfMemory, and a sentence with the numbers, when the memory or a limit of the device does not suffice;
// with deviceLost on a lost device.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/handle.h"

namespace macula::gpu {

enum class MemoryKind {
    deviceLocal,  // fast for the GPU; on a CPU or integrated device it is host memory, and mapped
    upload,       // written by the host, read by the GPU
    readback,     // written by the GPU, read by the host
};

struct BufferOptions {
    std::string label = "buffer";
    std::uint64_t bytes = 0;  // above 0
    // Copies from and to the buffer are always allowed. A storage buffer is limited to
    // DeviceInfo::maxStorageBufferBytes, which is only 128 MiB on lavapipe; shaders read larger data through
    // texel buffers.
    VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    MemoryKind memory = MemoryKind::deviceLocal;
};

// Equivalent of VkBuffer and VkDeviceMemory.
class Buffer {
  public:
    static Result<Buffer> create(const std::shared_ptr<Device>& device, const BufferOptions& options);

    VkBuffer handle() const { return buffer_.get(); }
    const std::shared_ptr<Device>& device() const { return buffer_.device(); }
    const std::string& label() const { return label_; }
    std::uint64_t bytes() const { return bytes_; }
    VkBufferUsageFlags usage() const { return usage_; }

    // The whole buffer, coherent; empty when it is not in host memory, which happens only for deviceLocal.
    // The GPU's writes are visible here once their ticket is done; work submitted after the host's writes
    // sees these.
    std::span<std::byte> mapped() const { return mapped_; }
    bool hostCached() const { return hostCached_; }  // false: reading `mapped` is very slow

  private:
    friend class TexelBuffer;
    friend class StagingPool;

    Buffer() = default;

    Handle<VkDeviceMemory> memory_;
    Handle<VkBuffer> buffer_;  // dropped before its memory
    std::string label_;
    std::uint64_t bytes_ = 0;
    VkBufferUsageFlags usage_ = 0;
    std::span<std::byte> mapped_;
    bool hostCached_ = false;
};

struct TexelBufferOptions {
    std::string label = "texel buffer";
    std::uint64_t elements = 0;  // above 0, at most DeviceInfo::maxTexelBufferElements if all are in one view
    VkFormat format = VK_FORMAT_UNDEFINED;  // a format that bytesPerTexel knows
    VkBufferUsageFlags usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
    MemoryKind memory = MemoryKind::deviceLocal;
    // Elements of each view except the last; their bytes must be a multiple of 256. 0: one view.
    std::uint64_t elementsOfView = 0;
};

// A buffer that shaders read by texelFetch: `usamplerBuffer` for R16_UINT and R32_UINT, `samplerBuffer` for
// the float formats. By far the fastest read-only array on lavapipe.
class TexelBuffer {
  public:
    static Result<TexelBuffer> create(const std::shared_ptr<Device>& device,
                                      const TexelBufferOptions& options);

    const Buffer& buffer() const { return buffer_; }
    std::size_t viewCount() const { return views_.size(); }
    VkBufferView view(std::size_t index = 0) const { return views_[index].get(); }
    // The texels from the first of this view on; empty when the buffer is not mapped.
    std::span<std::byte> mappedFrom(std::size_t view) const;
    VkFormat format() const { return format_; }
    std::uint64_t elements() const { return elements_; }

  private:
    TexelBuffer() = default;

    Buffer buffer_;
    std::vector<Handle<VkBufferView>> views_;  // dropped before the buffer
    VkFormat format_ = VK_FORMAT_UNDEFINED;
    std::uint64_t elements_ = 0;
    std::uint64_t bytesOfView_ = 0;
};

enum class ImageShape { flat, volume };  // image2D and sampler2D, or image3D and sampler3D

struct ImageOptions {
    std::string label = "image";
    ImageShape shape = ImageShape::flat;
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t depth = 1;  // 1 unless a volume
    VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
    VkImageUsageFlags usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                              VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
};

// Equivalent of VkImage, VkImageView and VkDeviceMemory: one mip level, one layer, always in the layout
// GENERAL.
class Image {
  public:
    // Also submits the transition to GENERAL; nobody needs to wait for it. The content is undefined until
    // written. Fails with deviceNotUsable when the device cannot use the format in this way.
    static Result<Image> create(const std::shared_ptr<Device>& device, const ImageOptions& options);

    VkImage handle() const { return image_.get(); }
    VkImageView view() const { return view_.get(); }
    const std::shared_ptr<Device>& device() const { return image_.device(); }
    const std::string& label() const { return options_.label; }
    VkExtent3D extent() const { return {options_.width, options_.height, options_.depth}; }
    VkFormat format() const { return options_.format; }
    ImageShape shape() const { return options_.shape; }
    VkImageUsageFlags usage() const { return options_.usage; }
    std::uint64_t texels() const { return std::uint64_t(options_.width) * options_.height * options_.depth; }
    std::uint64_t bytes() const { return texels() * texelBytes_; }  // tightly packed, as copies see it

  private:
    Image() = default;

    ImageOptions options_;
    std::uint32_t texelBytes_ = 0;
    Handle<VkDeviceMemory> memory_;
    Handle<VkImage> image_;  // dropped before its memory
    Handle<VkImageView> view_;
};

struct SamplerOptions {
    std::string label = "sampler";
    VkFilter filter = VK_FILTER_LINEAR;
    VkSamplerAddressMode addressU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkSamplerAddressMode addressV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkSamplerAddressMode addressW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
};

// Equivalent of VkSampler.
class Sampler {
  public:
    static Result<Sampler> create(const std::shared_ptr<Device>& device, const SamplerOptions& options = {});

    VkSampler handle() const { return sampler_.get(); }

  private:
    Sampler() = default;

    Handle<VkSampler> sampler_;
};

// The bytes of one texel of the formats that Macula uses, else 0: R8, RG8, RGBA8, BGRA8, R16, RG16, RGBA16,
// R32, RG32, RGBA32 in their UNORM, UINT, SINT and SFLOAT forms.
std::uint32_t bytesPerTexel(VkFormat format);

}  // namespace macula::gpu
