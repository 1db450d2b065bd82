#include "pipeline/gpu/resources.h"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/staging_pool.h"
#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

Error tooLarge(const Device& device, const Text& what, const Text& needs, const Text& allows) {
    return {ErrorCode::outOfMemory,
            Text("The {} does not fit on the device {}: it needs {}, and the device allows {}.", what,
                 device.info().name, needs, allows),
            "", Text("Open a smaller series, or choose a device with more memory by MACULA_DEVICE.")};
}

// The first memory type that has all flags of an alternative; earlier alternatives come first.
std::optional<std::uint32_t> findMemoryType(const VkPhysicalDeviceMemoryProperties& memory,
                                            std::uint32_t allowedTypes,
                                            std::initializer_list<VkMemoryPropertyFlags> alternatives) {
    for (const VkMemoryPropertyFlags wanted : alternatives)
        for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type)
            if ((allowedTypes & (1u << type)) && (memory.memoryTypes[type].propertyFlags & wanted) == wanted)
                return type;
    return std::nullopt;
}

std::optional<std::uint32_t> memoryTypeFor(const Device& device,
                                           const VkPhysicalDeviceMemoryProperties& memory,
                                           std::uint32_t allowedTypes, MemoryKind kind) {
    constexpr VkMemoryPropertyFlags kLocal = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    constexpr VkMemoryPropertyFlags kHost =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    constexpr VkMemoryPropertyFlags kCached = kHost | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    switch (kind) {
        case MemoryKind::deviceLocal:
            return device.hasUnifiedMemory()
                       ? findMemoryType(memory, allowedTypes, {kLocal | kCached, kLocal | kHost, kLocal, 0})
                       : findMemoryType(memory, allowedTypes, {kLocal, 0});
        case MemoryKind::upload:
            return findMemoryType(memory, allowedTypes, {kHost});
        case MemoryKind::readback:
            return findMemoryType(memory, allowedTypes, {kCached, kHost});
    }
    return std::nullopt;
}

struct Allocation {
    Handle<VkDeviceMemory> memory;
    VkMemoryPropertyFlags flags = 0;
};

Result<Allocation> allocate(const std::shared_ptr<Device>& device, const VkMemoryRequirements& requirements,
                            MemoryKind kind, const Text& what, VkBuffer buffer, VkImage image) {
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(device->physical(), &memory);
    const auto type = memoryTypeFor(*device, memory, requirements.memoryTypeBits, kind);
    if (!type) return device->failed(VK_ERROR_FEATURE_NOT_PRESENT, Text("find memory for the {}", what));
    const std::uint64_t heapBytes = memory.memoryHeaps[memory.memoryTypes[*type].heapIndex].size;
    if (requirements.size > heapBytes)
        return tooLarge(*device, what, bytesText(requirements.size), bytesText(heapBytes));

    VkMemoryDedicatedAllocateInfo dedicated{VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO};
    dedicated.buffer = buffer;
    dedicated.image = image;
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, &dedicated};
    info.allocationSize = requirements.size;
    info.memoryTypeIndex = *type;

    const auto tryAllocate = [&](VkDeviceMemory* result) {
        return vkAllocateMemory(device->handle(), &info, nullptr, result);
    };
    VkDeviceMemory handle = VK_NULL_HANDLE;
    VkResult result = tryAllocate(&handle);
    const bool isFull = result == VK_ERROR_OUT_OF_DEVICE_MEMORY;
    // Frees kept staging memory where it is the same memory. On a graphics card that would not help, and it
    // may be the only staging memory left for reading results back.
    if (isFull && kind == MemoryKind::deviceLocal && device->hasUnifiedMemory())
        device->staging().clear(device);
    if (isFull && device->pendingDestructions() > 0) {
        // Dropped objects may still hold the memory: worth one wait before giving up.
        MACULA_TRY_VOID(device->waitForAll());
        result = tryAllocate(&handle);
    }
    if (result < 0)
        return device->failed(result, Text("get {} for the {}", bytesText(requirements.size), what));
    return Allocation{Handle(device, handle), memory.memoryTypes[*type].propertyFlags};
}

}  // namespace

Result<Buffer> Buffer::create(const std::shared_ptr<Device>& device, const BufferOptions& options) {
    MACULA_CHECK(device != nullptr);
    MACULA_CHECK(options.bytes > 0);
    const DeviceInfo& info = device->info();
    const Text what = Text("buffer \"{}\"", options.label);
    MACULA_TRY_VOID(device->checkNotLost(Text("create the {}", what)));
    std::uint64_t limit = info.maxAllocationBytes;
    if (options.usage & VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)
        limit = std::min<std::uint64_t>(limit, info.maxStorageBufferBytes);
    if (options.bytes > limit) return tooLarge(*device, what, bytesText(options.bytes), bytesText(limit));

    Buffer result;
    result.label_ = options.label;
    result.bytes_ = options.bytes;
    result.usage_ = options.usage | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkBufferCreateInfo bufferInfo{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    bufferInfo.size = options.bytes;
    bufferInfo.usage = result.usage_;
    VkBuffer handle = VK_NULL_HANDLE;
    if (const VkResult status = vkCreateBuffer(device->handle(), &bufferInfo, nullptr, &handle); status < 0)
        return device->failed(status, Text("create the {} of {}", what, bytesText(options.bytes)));
    result.buffer_ = Handle(device, handle);
    device->setName(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<std::uint64_t>(handle), options.label);

    VkMemoryRequirements requirements{};
    vkGetBufferMemoryRequirements(device->handle(), handle, &requirements);
    MACULA_TRY(Allocation allocation,
               allocate(device, requirements, options.memory, what, handle, VK_NULL_HANDLE));
    const VkDeviceMemory memory = allocation.memory.get();
    result.memory_ = std::move(allocation.memory);
    if (const VkResult status = vkBindBufferMemory(device->handle(), handle, memory, 0); status < 0)
        return device->failed(status, Text("bind memory to the {}", what));

    constexpr VkMemoryPropertyFlags kMappable =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const bool map = (allocation.flags & kMappable) == kMappable &&
                     (device->hasUnifiedMemory() || options.memory != MemoryKind::deviceLocal);
    if (map) {
        void* data = nullptr;
        if (const VkResult status = vkMapMemory(device->handle(), memory, 0, VK_WHOLE_SIZE, 0, &data);
            status < 0)
            return device->failed(status, Text("map the {}", what));
        result.mapped_ = {static_cast<std::byte*>(data), static_cast<std::size_t>(options.bytes)};
        result.hostCached_ = (allocation.flags & VK_MEMORY_PROPERTY_HOST_CACHED_BIT) != 0;
    }
    return result;
}

Result<TexelBuffer> TexelBuffer::create(const std::shared_ptr<Device>& device,
                                        const TexelBufferOptions& options) {
    MACULA_CHECK(device != nullptr);
    MACULA_CHECK(options.elements > 0);
    MACULA_CHECK(bytesPerTexel(options.format) > 0);
    const Text what = Text("texel buffer \"{}\"", options.label);
    const std::uint64_t ofView = options.elementsOfView > 0 ? options.elementsOfView : options.elements;
    const std::uint64_t limit = device->info().maxTexelBufferElements;
    if (std::min(options.elements, ofView) > limit)
        return tooLarge(*device, what, Text("{} elements", std::to_string(options.elements)),
                        Text::verbatim(std::to_string(limit)));
    const std::uint64_t viewBytes = ofView * bytesPerTexel(options.format);
    // 256 is the largest minTexelBufferOffsetAlignment that Vulkan allows.
    MACULA_CHECK(ofView >= options.elements || viewBytes % 256 == 0);

    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device->physical(), options.format, &properties);
    const bool readable = (properties.bufferFeatures & VK_FORMAT_FEATURE_UNIFORM_TEXEL_BUFFER_BIT) != 0;
    const bool writable = (properties.bufferFeatures & VK_FORMAT_FEATURE_STORAGE_TEXEL_BUFFER_BIT) != 0;
    if (((options.usage & VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT) && !readable) ||
        ((options.usage & VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT) && !writable))
        return device->failed(VK_ERROR_FORMAT_NOT_SUPPORTED, Text("create the {}", what));

    TexelBuffer result;
    result.format_ = options.format;
    result.elements_ = options.elements;
    result.bytesOfView_ = viewBytes;
    MACULA_TRY(result.buffer_,
               Buffer::create(device, {.label = options.label,
                                       .bytes = options.elements * bytesPerTexel(options.format),
                                       .usage = options.usage,
                                       .memory = options.memory}));
    VkBufferViewCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
    info.buffer = result.buffer_.handle();
    info.format = options.format;
    for (std::uint64_t first = 0; first < options.elements; first += ofView) {
        info.offset = first * bytesPerTexel(options.format);
        info.range = std::min(viewBytes, result.buffer_.bytes() - info.offset);
        VkBufferView view = VK_NULL_HANDLE;
        if (const VkResult status = vkCreateBufferView(device->handle(), &info, nullptr, &view); status < 0)
            return device->failed(status, Text("create the {}", what));
        result.views_.emplace_back(device, view);
    }
    return result;
}

std::span<std::byte> TexelBuffer::mappedFrom(std::size_t view) const {
    const std::span<std::byte> all = buffer_.mapped();
    return all.empty() ? all : all.subspan(view * bytesOfView_);
}

namespace {

constexpr VkImageSubresourceRange kWholeImage{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};

// Also fails if the device cannot use the format in this way.
VkResult createImage(const Device& device, const ImageOptions& options, VkExtent3D extent, VkImage& handle) {
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = options.shape == ImageShape::volume ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
    info.format = options.format;
    info.extent = extent;
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = options.usage;
    VkImageFormatProperties properties{};
    if (const VkResult status = vkGetPhysicalDeviceImageFormatProperties(
            device.physical(), info.format, info.imageType, info.tiling, info.usage, 0, &properties);
        status < 0)
        return status;
    return vkCreateImage(device.handle(), &info, nullptr, &handle);
}

VkResult createView(const Device& device, const ImageOptions& options, VkImage image, VkImageView& view) {
    VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    info.image = image;
    info.viewType = options.shape == ImageShape::volume ? VK_IMAGE_VIEW_TYPE_3D : VK_IMAGE_VIEW_TYPE_2D;
    info.format = options.format;
    info.subresourceRange = kWholeImage;
    return vkCreateImageView(device.handle(), &info, nullptr, &view);
}

// Submits the transition; later submissions wait for it.
Result<void> moveToGeneral(const std::shared_ptr<Device>& device, VkImage image) {
    MACULA_TRY(auto recorder, Recorder::create(device, "image to GENERAL"));
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    barrier.image = image;
    barrier.subresourceRange = kWholeImage;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(recorder.commands(), &dependency);
    MACULA_TRY_VOID(recorder.submit());
    return {};
}

}  // namespace

Result<Image> Image::create(const std::shared_ptr<Device>& device, const ImageOptions& options) {
    MACULA_CHECK(device != nullptr);
    MACULA_CHECK(options.width > 0 && options.height > 0 && options.depth > 0);
    MACULA_CHECK(bytesPerTexel(options.format) > 0);
    const bool isVolume = options.shape == ImageShape::volume;
    MACULA_CHECK(isVolume || options.depth == 1);
    const Text what = Text("image \"{}\"", options.label);
    MACULA_TRY_VOID(device->checkNotLost(Text("create the {}", what)));
    const DeviceInfo& info = device->info();
    const std::uint32_t edge = std::max({options.width, options.height, options.depth});
    const std::uint32_t maxEdge = isVolume ? info.maxImageEdge3D : info.maxImageEdge2D;
    if (edge > maxEdge)
        return tooLarge(*device, what, Text("{} pixels along one edge", edge),
                        Text::verbatim(std::to_string(maxEdge)));

    Image result;
    result.options_ = options;
    result.texelBytes_ = bytesPerTexel(options.format);
    if (result.bytes() > info.maxAllocationBytes)
        return tooLarge(*device, what, bytesText(result.bytes()), bytesText(info.maxAllocationBytes));

    const Text doing =
        Text("create the {} of {} x {} x {}", what, options.width, options.height, options.depth);
    VkImage handle = VK_NULL_HANDLE;
    if (const VkResult status = createImage(*device, options, result.extent(), handle); status < 0)
        return device->failed(status, doing);
    result.image_ = Handle(device, handle);
    device->setName(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(handle), options.label);

    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(device->handle(), handle, &requirements);
    MACULA_TRY(Allocation allocation,
               allocate(device, requirements, MemoryKind::deviceLocal, what, VK_NULL_HANDLE, handle));
    result.memory_ = std::move(allocation.memory);
    if (const VkResult status = vkBindImageMemory(device->handle(), handle, result.memory_.get(), 0);
        status < 0)
        return device->failed(status, doing);

    constexpr VkImageUsageFlags kViewable = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    if (options.usage & kViewable) {
        VkImageView view = VK_NULL_HANDLE;
        if (const VkResult status = createView(*device, options, handle, view); status < 0)
            return device->failed(status, doing);
        result.view_ = Handle(device, view);
    }
    MACULA_TRY_VOID(moveToGeneral(device, handle));
    return result;
}

Result<Sampler> Sampler::create(const std::shared_ptr<Device>& device, const SamplerOptions& options) {
    MACULA_CHECK(device != nullptr);
    MACULA_TRY_VOID(device->checkNotLost(Text("create the sampler \"{}\"", options.label)));
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = options.filter;
    info.minFilter = options.filter;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = options.addressU;
    info.addressModeV = options.addressV;
    info.addressModeW = options.addressW;
    VkSampler handle = VK_NULL_HANDLE;
    if (const VkResult status = vkCreateSampler(device->handle(), &info, nullptr, &handle); status < 0)
        return device->failed(status, Text("create the sampler \"{}\"", options.label));
    Sampler result;
    result.sampler_ = Handle(device, handle);
    device->setName(VK_OBJECT_TYPE_SAMPLER, reinterpret_cast<std::uint64_t>(handle), options.label);
    return result;
}

std::uint32_t bytesPerTexel(VkFormat format) {
    switch (format) {
        case VK_FORMAT_R8_UNORM:
        case VK_FORMAT_R8_UINT:
        case VK_FORMAT_R8_SINT:
            return 1;
        case VK_FORMAT_R8G8_UNORM:
        case VK_FORMAT_R8G8_UINT:
        case VK_FORMAT_R8G8_SINT:
        case VK_FORMAT_R16_UNORM:
        case VK_FORMAT_R16_UINT:
        case VK_FORMAT_R16_SINT:
        case VK_FORMAT_R16_SFLOAT:
            return 2;
        case VK_FORMAT_R8G8B8A8_UNORM:
        case VK_FORMAT_R8G8B8A8_UINT:
        case VK_FORMAT_R8G8B8A8_SINT:
        case VK_FORMAT_B8G8R8A8_UNORM:
        case VK_FORMAT_R16G16_UNORM:
        case VK_FORMAT_R16G16_UINT:
        case VK_FORMAT_R16G16_SINT:
        case VK_FORMAT_R16G16_SFLOAT:
        case VK_FORMAT_R32_UINT:
        case VK_FORMAT_R32_SINT:
        case VK_FORMAT_R32_SFLOAT:
            return 4;
        case VK_FORMAT_R16G16B16A16_UNORM:
        case VK_FORMAT_R16G16B16A16_UINT:
        case VK_FORMAT_R16G16B16A16_SINT:
        case VK_FORMAT_R16G16B16A16_SFLOAT:
        case VK_FORMAT_R32G32_UINT:
        case VK_FORMAT_R32G32_SINT:
        case VK_FORMAT_R32G32_SFLOAT:
            return 8;
        case VK_FORMAT_R32G32B32A32_UINT:
        case VK_FORMAT_R32G32B32A32_SINT:
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            return 16;
        default:
            return 0;
    }
}

}  // namespace macula::gpu
