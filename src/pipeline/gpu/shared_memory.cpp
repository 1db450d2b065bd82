#include "pipeline/gpu/shared_memory.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <cerrno>

#include "pipeline/gpu/device.h"

namespace macula::gpu {
namespace {

constexpr std::uint32_t kMostEdgePx = 16384;
constexpr std::uint32_t kUsages = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                  VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_INPUT_ATTACHMENT_BIT;
constexpr std::uint32_t kFlags =
    VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT | VK_IMAGE_CREATE_EXTENDED_USAGE_BIT | VK_IMAGE_CREATE_ALIAS_BIT;

Error refused(Text what, Text advice) {
    return {ErrorCode::usage, std::move(what), "", std::move(advice)};
}

// The usages of which an image needs one to be left in `layout`; 0 if it cannot be left so.
std::uint32_t usagesOf(std::uint32_t layout) {
    switch (layout) {
        case VK_IMAGE_LAYOUT_GENERAL:
        case VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL:
            return VK_IMAGE_USAGE_TRANSFER_DST_BIT;
        case VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL:
            return VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
        case VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL:
            return VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_INPUT_ATTACHMENT_BIT;
        case VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL:
            return VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
        default:
            return 0;
    }
}

Result<void> checkImage(const SharedMemoryHandles& options) {
    if (options.width < 1 || options.height < 1 || options.width > kMostEdgePx ||
        options.height > kMostEdgePx)
        return refused(Text("An image of {} x {} pixels cannot be shared.", options.width, options.height),
                       Text("Give one of 1 to {} pixels a side.", kMostEdgePx));
    if (options.format != VK_FORMAT_R8G8B8A8_UNORM && options.format != VK_FORMAT_R8G8B8A8_SRGB)
        return refused(Text("The pixels of the shared image are of a kind that Macula does not write."),
                       Text("Share one of VK_FORMAT_R8G8B8A8_UNORM or VK_FORMAT_R8G8B8A8_SRGB."));
    if (options.tiling != VK_IMAGE_TILING_OPTIMAL && options.tiling != VK_IMAGE_TILING_LINEAR)
        return refused(Text("The tiling of the shared image is not known."),
                       Text("Share one of VK_IMAGE_TILING_OPTIMAL or VK_IMAGE_TILING_LINEAR."));
    if (!(options.usage & VK_IMAGE_USAGE_TRANSFER_DST_BIT) || (options.usage & ~kUsages))
        return refused(
            Text("The shared image was not made for being written to, or for more than is known."),
            Text("Make it with VK_IMAGE_USAGE_TRANSFER_DST_BIT, and no more than transfers, sampling, "
                 "storage, and attachments of colour."));
    if (options.flags & ~kFlags)
        return refused(Text("The shared image was made with flags that Macula does not know."),
                       Text("Use no more than those for a mutable format, extended usage and aliases."));
    if (!(usagesOf(options.layout) & options.usage))
        return refused(
            Text("The shared image cannot be left in the layout that was asked for."),
            Text("Ask for VK_IMAGE_LAYOUT_GENERAL, or for a layout of something that the image was made "
                 "for."));
    return {};
}

Result<void> checkAllocation(const SharedMemoryHandles& options) {
    if (options.memory <= 0)
        return refused(Text("No memory was shared."),
                       Text("Give a file descriptor of vkGetMemoryFdKHR, above 0."));
    const std::uint64_t leastBytes = std::uint64_t{4} * options.width * options.height;
    if (options.offsetBytes > options.bytes || options.bytes - options.offsetBytes < leastBytes)
        return refused(
            Text("The shared memory of {} bytes has no room for an image of {} x {} pixels at byte {}.",
                 options.bytes, options.width, options.height, options.offsetBytes),
            Text("Give VkMemoryAllocateInfo::allocationSize, and the offset that the image was bound at."));
    if (options.isDedicated && options.offsetBytes != 0)
        return refused(Text("A dedicated allocation has its image at the beginning, and this one has not."),
                       Text("Give the offset 0, or share memory that is not dedicated."));
    if (options.memoryType >= VK_MAX_MEMORY_TYPES)
        return refused(Text("The shared memory is of a type that does not exist."),
                       Text("Give VkMemoryAllocateInfo::memoryTypeIndex."));
    if (options.card == CardIdentity())
        return refused(Text("It was not said which graphics card the shared memory is of."),
                       Text("Give deviceUUID and driverUUID of VkPhysicalDeviceIDProperties."));
    return {};
}

// A copy of the descriptor, if a driver may be given it, as far as the system can tell. A driver that reads
// from a pipe waits for ever, and NVIDIA's (580.159.04) opens no memory any more once it was given a file on
// disk. Drivers on a CPU share files in memory; only those can have seals.
Result<FileDescriptor> copyFor(int descriptor, const Text& what, const char* madeBy) {
    MACULA_TRY(FileDescriptor copy, FileDescriptor::copyOf(descriptor));
    struct stat file {};
    if (fstat(copy.get(), &file) != 0) return copy;
    const bool isOfDisk = S_ISREG(file.st_mode) && fcntl(copy.get(), F_GET_SEALS) < 0;
    if (isOfDisk || S_ISFIFO(file.st_mode) || S_ISSOCK(file.st_mode) || S_ISDIR(file.st_mode))
        return refused(
            Text("What was shared as {} is a file, a pipe, a socket or a folder, and no {}.", what, what),
            Text("Give a file descriptor of {}.", madeBy));
    return copy;
}

Result<FileDescriptor> semaphoreCopy(int descriptor) {
    if (descriptor <= 0) return FileDescriptor();
    return copyFor(descriptor, Text("semaphore"), "vkGetSemaphoreFdKHR");
}

}  // namespace

CardIdentity identityOf(const Device& device) {
    VkPhysicalDeviceIDProperties ids{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &ids, {}};
    vkGetPhysicalDeviceProperties2(device.physical(), &properties);
    CardIdentity identity;
    std::copy_n(ids.deviceUUID, identity.device.size(), identity.device.begin());
    std::copy_n(ids.driverUUID, identity.driver.size(), identity.driver.begin());
    return identity;
}

Result<SharedMemory> SharedMemory::create(const SharedMemoryHandles& options) {
    SharedMemory shared;
    shared.options_ = options;
    if (options.layout == VK_IMAGE_LAYOUT_UNDEFINED) shared.options_.layout = VK_IMAGE_LAYOUT_GENERAL;
    MACULA_TRY_VOID(checkImage(shared.options_));
    MACULA_TRY_VOID(checkAllocation(shared.options_));
    MACULA_TRY(shared.memory_, copyFor(options.memory, Text("memory"), "vkGetMemoryFdKHR"));
    MACULA_TRY(shared.wait_, semaphoreCopy(options.wait));
    MACULA_TRY(shared.signal_, semaphoreCopy(options.signal));
    return shared;
}

Result<FileDescriptor> FileDescriptor::copyOf(int descriptor) {
    // Above stdin, stdout and stderr: if a program has closed these, output meant for them must not be
    // written into the copy.
    const int copy = fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (copy >= 0) return FileDescriptor(copy);
    if (errno == EMFILE || errno == ENFILE)
        return Error{
            ErrorCode::outOfMemory,
            Text("This program has as many files open as it may, so what is shared cannot be opened."), "",
            Text("Close what is not needed, or let the program open more files (ulimit -n).")};
    return Error{
        ErrorCode::usage, Text("A file descriptor of what is shared is not open."), "",
        Text("Give one that vkGetMemoryFdKHR or vkGetSemaphoreFdKHR made, and close it afterwards.")};
}

FileDescriptor::~FileDescriptor() {
    if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace macula::gpu
