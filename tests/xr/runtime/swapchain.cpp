// Swapchains: real images on the application's device, and what was left in them.
#include <algorithm>
#include <cstring>

#include "xr/runtime/state.h"

namespace macula::xr_script {

namespace {

constexpr std::uint32_t kImages = 3;

std::vector<std::int64_t> formats() {
    std::vector<std::int64_t> taken{VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_B8G8R8A8_SRGB};
    if (state().extensions.contains(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME))
        taken.push_back(VK_FORMAT_D32_SFLOAT);
    return taken;
}
bool takes(std::int64_t format) {
    const std::vector<std::int64_t> taken = formats();
    return std::find(taken.begin(), taken.end(), format) != taken.end();
}

VkImageAspectFlags aspectOf(std::int64_t format) {
    return format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}
// In which images are lent, and are given back.
VkImageLayout layoutOf(std::int64_t format) {
    return format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL
                                          : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
}

// The first kind of memory that the bits allow and that is like this.
std::optional<std::uint32_t> memoryKind(VkPhysicalDevice device, std::uint32_t bits,
                                        VkMemoryPropertyFlags like) {
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(device, &memory);
    for (std::uint32_t kind = 0; kind < memory.memoryTypeCount; ++kind)
        if ((bits & (1u << kind)) && (memory.memoryTypes[kind].propertyFlags & like) == like) return kind;
    return std::nullopt;
}

VkDeviceMemory allocate(const SessionState& session, const VkMemoryRequirements& needs,
                        VkMemoryPropertyFlags like) {
    const auto kind = memoryKind(session.physical, needs.memoryTypeBits, like);
    if (!kind) return VK_NULL_HANDLE;
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    info.allocationSize = needs.size;
    info.memoryTypeIndex = *kind;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    vkAllocateMemory(session.device, &info, nullptr, &memory);
    return memory;
}

void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, std::uint32_t layers,
             VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier info{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    info.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    info.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    info.oldLayout = from;
    info.newLayout = to;
    info.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    info.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    info.image = image;
    info.subresourceRange = {aspect, 0, 1, 0, layers};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0,
                         0, nullptr, 0, nullptr, 1, &info);
}

// Records, submits and waits.
template <class Record>
void run(const SessionState& session, const Record& recordInto) {
    VkCommandBufferAllocateInfo allocation{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocation.commandPool = session.pool;
    allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocation.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    if (vkAllocateCommandBuffers(session.device, &allocation, &commands) != VK_SUCCESS) return;
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    vkBeginCommandBuffer(commands, &begin);
    recordInto(commands);
    vkEndCommandBuffer(commands);
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    vkQueueSubmit(session.queue, 1, &submit, VK_NULL_HANDLE);
    vkQueueWaitIdle(session.queue);
    vkFreeCommandBuffers(session.device, session.pool, 1, &commands);
}

VkImageUsageFlags usageOf(XrSwapchainUsageFlags wanted) {
    VkImageUsageFlags usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;  // this runtime reads it
    if (wanted & XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT) usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    if (wanted & XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT)
        usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    if (wanted & XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT) usage |= VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if (wanted & XR_SWAPCHAIN_USAGE_SAMPLED_BIT) usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
    return usage;
}

bool addImage(const SessionState& session, SwapchainState& swapchain) {
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = VkFormat(swapchain.info.format);
    info.extent = {swapchain.info.width, swapchain.info.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = swapchain.info.arraySize;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = usageOf(swapchain.info.usageFlags);
    VkImage image = VK_NULL_HANDLE;
    if (vkCreateImage(session.device, &info, nullptr, &image) != VK_SUCCESS) return false;
    swapchain.images.push_back(image);
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(session.device, image, &needs);
    swapchain.memories.push_back(allocate(session, needs, 0));
    if (!swapchain.memories.back()) return false;
    if (vkBindImageMemory(session.device, image, swapchain.memories.back(), 0) != VK_SUCCESS) return false;
    run(session, [&](VkCommandBuffer commands) {
        barrier(commands, image, aspectOf(swapchain.info.format), info.arrayLayers, VK_IMAGE_LAYOUT_UNDEFINED,
                layoutOf(swapchain.info.format));
    });
    return true;
}

XrResult XRAPI_CALL enumerateFormats(XrSession session, std::uint32_t capacity, std::uint32_t* count,
                                     std::int64_t* told) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = enteredSession("xrEnumerateSwapchainFormats", session); lost != XR_SUCCESS)
        return lost;
    const std::vector<std::int64_t> taken = formats();
    *count = std::uint32_t(taken.size());
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < *count) return XR_ERROR_SIZE_INSUFFICIENT;
    std::copy(taken.begin(), taken.end(), told);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL createSwapchain(XrSession session, const XrSwapchainCreateInfo* info,
                                    XrSwapchain* swapchain) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    if (const XrResult lost = enteredSession("xrCreateSwapchain", session); lost != XR_SUCCESS) return lost;
    if (info->type != XR_TYPE_SWAPCHAIN_CREATE_INFO || info->sampleCount != 1 || info->faceCount != 1 ||
        info->mipCount != 1 || info->width == 0 || info->height == 0)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrCreateSwapchain: the structure");
    if (!takes(info->format))
        return wrong(XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, "xrCreateSwapchain: the format");
    if (info->usageFlags & XR_SWAPCHAIN_USAGE_UNORDERED_ACCESS_BIT)
        return wrong(XR_ERROR_FEATURE_UNSUPPORTED, "xrCreateSwapchain: storage of an sRGB format");
    const XrSwapchainUsageFlags attachment = info->format == VK_FORMAT_D32_SFLOAT
                                                 ? XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                                 : XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT;
    if (!(info->usageFlags & attachment))
        return wrong(XR_ERROR_FEATURE_UNSUPPORTED, "xrCreateSwapchain: the usage");
    if (info->arraySize > (s.script.takesLayers ? 2u : 1u)) return XR_ERROR_FEATURE_UNSUPPORTED;
    auto made = std::make_unique<SwapchainState>();
    made->info = *info;
    for (std::uint32_t i = 0; i < kImages; ++i) {
        if (!addImage(*s.session, *made)) {
            destroySwapchainNow(*made);
            return XR_ERROR_RUNTIME_FAILURE;
        }
    }
    *swapchain = nextHandle<XrSwapchain>();
    s.swapchains[*swapchain] = std::move(made);
    ++s.record.swapchains;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroySwapchain(XrSwapchain swapchain) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    const auto found = s.swapchains.find(swapchain);
    if (found == s.swapchains.end()) return wrong(XR_ERROR_HANDLE_INVALID, "xrDestroySwapchain");
    destroySwapchainNow(*found->second);
    s.swapchains.erase(found);
    --s.record.swapchains;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerateImages(XrSwapchain swapchain, std::uint32_t capacity, std::uint32_t* count,
                                    XrSwapchainImageBaseHeader* images) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    const auto found = s.swapchains.find(swapchain);
    if (found == s.swapchains.end()) return wrong(XR_ERROR_HANDLE_INVALID, "xrEnumerateSwapchainImages");
    *count = kImages;
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < kImages) return XR_ERROR_SIZE_INSUFFICIENT;
    auto* vulkan = reinterpret_cast<XrSwapchainImageVulkan2KHR*>(images);
    for (std::uint32_t i = 0; i < kImages; ++i) {
        if (vulkan[i].type != XR_TYPE_SWAPCHAIN_IMAGE_VULKAN2_KHR)
            return wrong(XR_ERROR_VALIDATION_FAILURE, "xrEnumerateSwapchainImages: type");
        vulkan[i].image = found->second->images[i];
    }
    return XR_SUCCESS;
}

// The swapchain; null, and `result` says why, where a loss or a wrong handle keeps anybody from using it.
SwapchainState* usable(const char* function, XrSwapchain swapchain, XrResult& result) {
    State& s = state();
    result = entered(function);
    if (result != XR_SUCCESS) return nullptr;
    if (s.session && s.session->isLost) {
        result = XR_ERROR_SESSION_LOST;
        return nullptr;
    }
    const auto found = s.swapchains.find(swapchain);
    if (found != s.swapchains.end()) return found->second.get();
    result = wrong(XR_ERROR_HANDLE_INVALID, std::string(function) + ": no swapchain");
    return nullptr;
}

XrResult XRAPI_CALL acquire(XrSwapchain swapchain, const XrSwapchainImageAcquireInfo*, std::uint32_t* index) {
    const std::lock_guard lock(state().mutex);
    XrResult result = XR_SUCCESS;
    SwapchainState* s = usable("xrAcquireSwapchainImage", swapchain, result);
    if (!s) return result;
    if (s->acquired.size() >= kImages)
        return wrong(XR_ERROR_CALL_ORDER_INVALID, "xrAcquireSwapchainImage: all are acquired");
    *index = state().script.lendsUnknownImage ? kImages : s->next;
    s->acquired.push_back(s->next);
    s->next = (s->next + 1) % kImages;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL wait(XrSwapchain swapchain, const XrSwapchainImageWaitInfo*) {
    const std::lock_guard lock(state().mutex);
    XrResult result = XR_SUCCESS;
    SwapchainState* s = usable("xrWaitSwapchainImage", swapchain, result);
    if (!s) return result;
    if (s->acquired.empty() || s->isWaited)
        return wrong(XR_ERROR_CALL_ORDER_INVALID, "xrWaitSwapchainImage without an acquired image");
    s->isWaited = true;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL release(XrSwapchain swapchain, const XrSwapchainImageReleaseInfo*) {
    const std::lock_guard lock(state().mutex);
    XrResult result = XR_SUCCESS;
    SwapchainState* s = usable("xrReleaseSwapchainImage", swapchain, result);
    if (!s) return result;
    if (!s->isWaited)
        return wrong(XR_ERROR_CALL_ORDER_INVALID, "xrReleaseSwapchainImage without xrWaitSwapchainImage");
    s->isWaited = false;
    s->released = s->acquired.front();
    s->acquired.pop_front();
    return XR_SUCCESS;
}

// The bytes of a part of a released image, four for each pixel.
std::vector<std::byte> readBytes(const SwapchainState& swapchain, std::uint32_t layer,
                                 const XrRect2Di& rect) {
    const SessionState& session = *state().session;
    const VkImageAspectFlags aspect = aspectOf(swapchain.info.format);
    const VkImageLayout kept = layoutOf(swapchain.info.format);
    std::vector<std::byte> bytes(std::size_t(rect.extent.width) * std::size_t(rect.extent.height) * 4);
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = bytes.size();
    info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    if (vkCreateBuffer(session.device, &info, nullptr, &buffer) != VK_SUCCESS) return {};
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(session.device, buffer, &needs);
    VkDeviceMemory memory =
        allocate(session, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    void* mapped = nullptr;
    if (memory && vkBindBufferMemory(session.device, buffer, memory, 0) == VK_SUCCESS &&
        vkMapMemory(session.device, memory, 0, VK_WHOLE_SIZE, 0, &mapped) == VK_SUCCESS) {
        const VkImage image = swapchain.images[*swapchain.released];
        const std::uint32_t layers = swapchain.info.arraySize;
        run(session, [&](VkCommandBuffer commands) {
            barrier(commands, image, aspect, layers, kept, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
            VkBufferImageCopy part{};
            part.imageSubresource = {aspect, 0, layer, 1};
            part.imageOffset = {rect.offset.x, rect.offset.y, 0};
            part.imageExtent = {std::uint32_t(rect.extent.width), std::uint32_t(rect.extent.height), 1};
            vkCmdCopyImageToBuffer(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1, &part);
            barrier(commands, image, aspect, layers, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kept);
            VkMemoryBarrier toHost{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
            toHost.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
            toHost.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
            vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                                 &toHost, 0, nullptr, 0, nullptr);
        });
        std::memcpy(bytes.data(), mapped, info.size);
    }
    vkDestroyBuffer(session.device, buffer, nullptr);
    vkFreeMemory(session.device, memory, nullptr);
    return bytes;
}

template <class Pixel>
std::vector<Pixel> readPixels(const SwapchainState& swapchain, std::uint32_t layer, const XrRect2Di& rect) {
    static_assert(sizeof(Pixel) == 4);
    const std::vector<std::byte> bytes = readBytes(swapchain, layer, rect);
    std::vector<Pixel> pixels(bytes.size() / sizeof(Pixel));
    if (!pixels.empty()) std::memcpy(pixels.data(), bytes.data(), bytes.size());
    return pixels;
}

}  // namespace

PFN_xrVoidFunction swapchainFunction(std::string_view name) {
#define MACULA_XR_IS(xrName, function) \
    if (name == xrName) return reinterpret_cast<PFN_xrVoidFunction>(function)
    MACULA_XR_IS("xrEnumerateSwapchainFormats", enumerateFormats);
    MACULA_XR_IS("xrCreateSwapchain", createSwapchain);
    MACULA_XR_IS("xrDestroySwapchain", destroySwapchain);
    MACULA_XR_IS("xrEnumerateSwapchainImages", enumerateImages);
    MACULA_XR_IS("xrAcquireSwapchainImage", acquire);
    MACULA_XR_IS("xrWaitSwapchainImage", wait);
    MACULA_XR_IS("xrReleaseSwapchainImage", release);
#undef MACULA_XR_IS
    return nullptr;
}

void destroySwapchainNow(SwapchainState& swapchain) {
    const SessionState& session = *state().session;
    vkQueueWaitIdle(session.queue);
    for (const VkImage image : swapchain.images) vkDestroyImage(session.device, image, nullptr);
    for (const VkDeviceMemory memory : swapchain.memories) vkFreeMemory(session.device, memory, nullptr);
}

std::vector<glm::u8vec4> readImage(const SwapchainState& swapchain, std::uint32_t layer,
                                   const XrRect2Di& rect) {
    return readPixels<glm::u8vec4>(swapchain, layer, rect);
}

std::vector<float> readDepths(const SwapchainState& swapchain, std::uint32_t layer, const XrRect2Di& rect) {
    return readPixels<float>(swapchain, layer, rect);
}

bool isDepth(const SwapchainState& swapchain) {
    return swapchain.info.format == VK_FORMAT_D32_SFLOAT;
}

void waitForDevice() {
    vkQueueWaitIdle(state().session->queue);
}

}  // namespace macula::xr_script
