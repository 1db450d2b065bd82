#include "pipeline/gpu/shared_image.h"

#include <utility>

#include "base/check.h"
#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

constexpr VkExternalMemoryHandleTypeFlagBits kMemoryHandle = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
constexpr VkExternalSemaphoreHandleTypeFlagBits kSemaphoreHandle =
    VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT;

Text doing() {
    return Text("open the image that another program shares");
}

Text asMade() {
    return Text("Describe the image and its memory exactly as they were made.");
}

Error refused(Text what, Text advice) {
    return {ErrorCode::usage, std::move(what), "", std::move(advice)};
}

// Null if the device was opened without the function's extension.
template <class Function>
Function functionOf(const Device& device, const char* name) {
    return reinterpret_cast<Function>(vkGetDeviceProcAddr(device.handle(), name));
}

Result<void> checkDevice(const Device& device, const SharedMemoryHandles& options) {
    if (identityOf(device) != options.card)
        return refused(
            Text("The shared image is of another graphics card, or another driver, than {}, which draws.",
                 device.info().name),
            Text("Ask macula_device_identify which card draws, and make the image on that one."));
    if (!functionOf<PFN_vkGetMemoryFdKHR>(device, "vkGetMemoryFdKHR"))
        return Error{
            ErrorCode::deviceNotUsable,
            Text("The device {} was opened without what images are shared by.", device.info().name), "",
            Text("Open it with VK_KHR_external_memory_fd; where it does not offer that, have pictures in "
                 "memory.")};
    return {};
}

VkImageCreateInfo imageInfo(const SharedMemoryHandles& options) {
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.flags = options.flags;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = static_cast<VkFormat>(options.format);
    info.extent = {options.width, options.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = static_cast<VkImageTiling>(options.tiling);
    info.usage = options.usage;
    return info;
}

// Checks that the device can import such an image at all.
Result<void> checkImportable(const Device& device, const VkImageCreateInfo& image, bool isDedicated) {
    VkPhysicalDeviceExternalImageFormatInfo external{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTERNAL_IMAGE_FORMAT_INFO};
    external.handleType = kMemoryHandle;
    VkPhysicalDeviceImageFormatInfo2 info{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_IMAGE_FORMAT_INFO_2, &external};
    info.format = image.format;
    info.type = image.imageType;
    info.tiling = image.tiling;
    info.usage = image.usage;
    info.flags = image.flags;
    VkExternalImageFormatProperties shared{VK_STRUCTURE_TYPE_EXTERNAL_IMAGE_FORMAT_PROPERTIES};
    VkImageFormatProperties2 properties{VK_STRUCTURE_TYPE_IMAGE_FORMAT_PROPERTIES_2, &shared, {}};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties2(device.physical(), &info, &properties);
    if (result < 0 && result != VK_ERROR_FORMAT_NOT_SUPPORTED) return device.failed(result, doing());
    const VkExtent3D most = properties.imageFormatProperties.maxExtent;
    const VkExternalMemoryFeatureFlags can = shared.externalMemoryProperties.externalMemoryFeatures;
    if (result < 0 || !(can & VK_EXTERNAL_MEMORY_FEATURE_IMPORTABLE_BIT) || image.extent.width > most.width ||
        image.extent.height > most.height)
        return refused(
            Text("The device {} cannot open a shared image like this.", device.info().name),
            Text("Share one of VK_FORMAT_R8G8B8A8_UNORM with optimal tiling, and for fewer uses."));
    if ((can & VK_EXTERNAL_MEMORY_FEATURE_DEDICATED_ONLY_BIT) && !isDedicated)
        return refused(Text("The device {} shares an image only with memory of its own.", device.info().name),
                       Text("Allocate it with VkMemoryDedicatedAllocateInfo, and say so."));
    return {};
}

Result<Handle<VkImage>> imageLike(const std::shared_ptr<Device>& device, VkImageCreateInfo info) {
    VkExternalMemoryImageCreateInfo external{VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_IMAGE_CREATE_INFO};
    external.handleTypes = kMemoryHandle;
    info.pNext = &external;
    VkImage image = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateImage(device->handle(), &info, nullptr, &image); result < 0)
        return device->failed(result, doing());
    device->setName(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image), "shared image");
    return Handle(device, image);
}

// Checks that the image fits into the shared memory as it would into our own.
Result<void> checkFits(const Device& device, VkImage image, const SharedMemoryHandles& options) {
    VkImageMemoryRequirementsInfo2 of{VK_STRUCTURE_TYPE_IMAGE_MEMORY_REQUIREMENTS_INFO_2};
    of.image = image;
    VkMemoryDedicatedRequirements dedicated{VK_STRUCTURE_TYPE_MEMORY_DEDICATED_REQUIREMENTS};
    VkMemoryRequirements2 requirements{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2, &dedicated, {}};
    vkGetImageMemoryRequirements2(device.handle(), &of, &requirements);
    const VkMemoryRequirements& needs = requirements.memoryRequirements;
    if (options.offsetBytes % needs.alignment != 0 || needs.size > options.bytes - options.offsetBytes)
        return refused(
            Text("The shared image needs {} bytes at a multiple of {}, and has {} at {}.", needs.size,
                 needs.alignment, options.bytes - options.offsetBytes, options.offsetBytes),
            asMade());
    if (options.isDedicated && needs.size != options.bytes)
        return refused(Text("The memory is said to be the shared image's alone, which needs {} bytes and "
                            "not {}.",
                            needs.size, options.bytes),
                       asMade());
    if (dedicated.requiresDedicatedAllocation && !options.isDedicated)
        return refused(Text("The shared image needs memory of its own, and is said to have none."),
                       Text("Allocate it with VkMemoryDedicatedAllocateInfo, and say so."));
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(device.physical(), &memory);
    if (options.memoryType >= memory.memoryTypeCount || !(needs.memoryTypeBits >> options.memoryType & 1))
        return refused(Text("The shared image cannot lie in memory of type {}.", options.memoryType),
                       Text("Give VkMemoryAllocateInfo::memoryTypeIndex of the memory that is shared."));
    if (options.bytes > memory.memoryHeaps[memory.memoryTypes[options.memoryType].heapIndex].size)
        return refused(Text("The device {} has no {} of memory that could be shared.", device.info().name,
                            bytesText(options.bytes)),
                       asMade());
    return {};
}

// Vulkan cannot tell what an opaque handle belongs to (vkGetMemoryFdPropertiesKHR is for other kinds), so
// size and type must be those of the allocation.
Result<Handle<VkDeviceMemory>> importMemory(const std::shared_ptr<Device>& device, VkImage image,
                                            const SharedMemory& shared) {
    const SharedMemoryHandles& options = shared.options();
    MACULA_TRY(FileDescriptor mine, FileDescriptor::copyOf(shared.memory().get()));
    VkMemoryDedicatedAllocateInfo dedicated{VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO};
    dedicated.image = image;
    VkImportMemoryFdInfoKHR import{VK_STRUCTURE_TYPE_IMPORT_MEMORY_FD_INFO_KHR};
    if (options.isDedicated) import.pNext = &dedicated;
    import.handleType = kMemoryHandle;
    import.fd = mine.get();
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, &import};
    info.allocationSize = options.bytes;
    info.memoryTypeIndex = options.memoryType;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    const VkResult result = vkAllocateMemory(device->handle(), &info, nullptr, &memory);
    // An import allocates nothing: if the driver reports a lack of memory, the shared memory is smaller than
    // stated.
    if (result == VK_ERROR_INVALID_EXTERNAL_HANDLE || result == VK_ERROR_OUT_OF_DEVICE_MEMORY)
        return refused(
            Text("What was shared is no memory of this graphics card, or smaller than it is said to be."),
            Text("Give a file descriptor of vkGetMemoryFdKHR with "
                 "VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT, and the size of the allocation."));
    if (result < 0) return device->failed(result, doing());
    mine.release();  // the driver owns it after a successful import
    return Handle(device, memory);
}

Result<void> checkSemaphores(const Device& device) {
    VkPhysicalDeviceExternalSemaphoreInfo info{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTERNAL_SEMAPHORE_INFO};
    info.handleType = kSemaphoreHandle;
    VkExternalSemaphoreProperties properties{VK_STRUCTURE_TYPE_EXTERNAL_SEMAPHORE_PROPERTIES};
    vkGetPhysicalDeviceExternalSemaphoreProperties(device.physical(), &info, &properties);
    const Text without = Text("Give none: then the picture is there when the call returns.");
    if (!(properties.externalSemaphoreFeatures & VK_EXTERNAL_SEMAPHORE_FEATURE_IMPORTABLE_BIT))
        return Error{ErrorCode::deviceNotUsable,
                     Text("The device {} cannot share semaphores with another program.", device.info().name),
                     "", without};
    if (!functionOf<PFN_vkImportSemaphoreFdKHR>(device, "vkImportSemaphoreFdKHR"))
        return Error{
            ErrorCode::deviceNotUsable,
            Text("The device {} was opened without what semaphores are shared by.", device.info().name), "",
            Text("{} Or open it with VK_KHR_external_semaphore_fd, if it offers that.", without)};
    return {};
}

// Imports permanently: signals and waits on the semaphore are shared with the other device.
Result<Handle<VkSemaphore>> importSemaphore(const std::shared_ptr<Device>& device,
                                            const FileDescriptor& shared) {
    if (!shared) return Handle<VkSemaphore>();
    MACULA_TRY_VOID(checkSemaphores(*device));
    MACULA_TRY(FileDescriptor mine, FileDescriptor::copyOf(shared.get()));
    const VkSemaphoreCreateInfo binary{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore made = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateSemaphore(device->handle(), &binary, nullptr, &made); result < 0)
        return device->failed(result, doing());
    Handle<VkSemaphore> semaphore(device, made);
    device->setName(VK_OBJECT_TYPE_SEMAPHORE, reinterpret_cast<std::uint64_t>(made), "shared semaphore");
    VkImportSemaphoreFdInfoKHR import{VK_STRUCTURE_TYPE_IMPORT_SEMAPHORE_FD_INFO_KHR};
    import.semaphore = made;
    import.handleType = kSemaphoreHandle;
    import.fd = mine.get();
    const auto importFd = functionOf<PFN_vkImportSemaphoreFdKHR>(*device, "vkImportSemaphoreFdKHR");
    const VkResult result = importFd(device->handle(), &import);
    if (result == VK_ERROR_INVALID_EXTERNAL_HANDLE)
        return refused(Text("What was shared as a semaphore is none of this graphics card."),
                       Text("Give a file descriptor of vkGetSemaphoreFdKHR with "
                            "VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT."));
    if (result < 0) return device->failed(result, doing());
    mine.release();
    return semaphore;
}

}  // namespace

Result<SharedImage> SharedImage::import(const std::shared_ptr<Device>& device, const SharedMemory& memory) {
    MACULA_CHECK(device != nullptr);
    MACULA_TRY_VOID(device->checkNotLost(doing()));
    const SharedMemoryHandles& options = memory.options();
    MACULA_TRY_VOID(checkDevice(*device, options));
    const VkImageCreateInfo info = imageInfo(options);
    MACULA_TRY_VOID(checkImportable(*device, info, options.isDedicated));

    SharedImage shared;
    shared.layout_ = static_cast<VkImageLayout>(options.layout);
    MACULA_TRY(shared.image_, imageLike(device, info));
    const VkImage image = shared.image_.get();
    MACULA_TRY_VOID(checkFits(*device, image, options));
    MACULA_TRY(shared.memory_, importMemory(device, image, memory));
    if (const VkResult result =
            vkBindImageMemory(device->handle(), image, shared.memory_.get(), options.offsetBytes);
        result < 0)
        return device->failed(result, doing());
    MACULA_TRY(shared.wait_, importSemaphore(device, memory.wait()));
    MACULA_TRY(shared.signal_, importSemaphore(device, memory.signal()));
    return shared;
}

}  // namespace macula::gpu
