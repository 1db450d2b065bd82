#include "pipeline/gpu/swapchain.h"

#include <algorithm>

#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

constexpr std::uint32_t kWantedImages = 3;

// UNORM, because our pixels are display-encoded already: an SRGB format would encode them again.
Result<VkSurfaceFormatKHR> chooseFormat(Device& device, VkSurfaceKHR surface) {
    std::uint32_t count = 0;
    VkResult result = vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, nullptr);
    std::vector<VkSurfaceFormatKHR> offered(count);
    if (result >= 0)
        result = vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, offered.data());
    if (result < 0) return device.failed(result, Text("ask for the formats of the window"));
    for (const VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM})
        for (const VkSurfaceFormatKHR& format : offered)
            if (format.format == wanted && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
                return format;
    return device.failed(VK_ERROR_FORMAT_NOT_SUPPORTED,
                         Text("find a format for the window with 8 bits per colour"));
}

VkPresentModeKHR chooseMode(const Device& device, VkSurfaceKHR surface, PresentMode wanted) {
    if (wanted == PresentMode::fifo) return VK_PRESENT_MODE_FIFO_KHR;
    std::uint32_t count = 0;
    vkGetPhysicalDeviceSurfacePresentModesKHR(device.physical(), surface, &count, nullptr);
    std::vector<VkPresentModeKHR> offered(count);
    vkGetPhysicalDeviceSurfacePresentModesKHR(device.physical(), surface, &count, offered.data());
    const bool has = std::find(offered.begin(), offered.end(), VK_PRESENT_MODE_MAILBOX_KHR) != offered.end();
    return has ? VK_PRESENT_MODE_MAILBOX_KHR : VK_PRESENT_MODE_FIFO_KHR;
}

}  // namespace

void Swapchain::DestroySwapchain::operator()(VkSwapchainKHR swapchain) const {
    vkDeviceWaitIdle(device->handle());  // presentation has no ticket to wait for
    vkDestroySwapchainKHR(device->handle(), swapchain, nullptr);
}

Result<Swapchain> Swapchain::create(const std::shared_ptr<Device>& device, VkSurfaceKHR surface,
                                    const SwapchainOptions& options) {
    MACULA_CHECK(device != nullptr);
    MACULA_CHECK(surface != VK_NULL_HANDLE);
    VkBool32 canPresent = VK_FALSE;
    if (const VkResult result = vkGetPhysicalDeviceSurfaceSupportKHR(
            device->physical(), device->queueFamily(), surface, &canPresent);
        result < 0)
        return device->failed(result, Text("ask whether the device can draw in the window"));
    if (!canPresent)
        return Error{ErrorCode::deviceNotUsable,
                     Text("The device {} cannot draw in this window.", device->info().name), "",
                     Text("Choose the device that drives the display by MACULA_DEVICE.")};
    Swapchain swapchain;
    swapchain.device_ = device;
    swapchain.surface_ = surface;
    MACULA_TRY(swapchain.format_, chooseFormat(*device, surface));
    swapchain.mode_ = chooseMode(*device, surface, options.mode);
    MACULA_TRY_VOID(swapchain.resize(options.extent));
    return swapchain;
}

Result<Handle<VkSemaphore>> Swapchain::makeSemaphore() const {
    const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore semaphore = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateSemaphore(device_->handle(), &info, nullptr, &semaphore); result < 0)
        return device_->failed(result, Text("create a semaphore"));
    return Handle(device_, semaphore);
}

Result<void> Swapchain::resize(VkExtent2D extent) {
    MACULA_TRY_VOID(device_->checkNotLost(Text("resize the window")));
    isBroken_ = true;  // until everything below has been made
    if (const VkResult result = vkDeviceWaitIdle(device_->handle()); result < 0)
        return device_->failed(result, Text("resize the window"));

    VkSurfaceCapabilitiesKHR surface{};
    if (const VkResult result =
            vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_->physical(), surface_, &surface);
        result < 0)
        return device_->failed(result, Text("ask for the size of the window"));
    if (surface.currentExtent.width != UINT32_MAX) {
        extent = surface.currentExtent;
    } else {
        extent.width = std::clamp(extent.width, surface.minImageExtent.width, surface.maxImageExtent.width);
        extent.height =
            std::clamp(extent.height, surface.minImageExtent.height, surface.maxImageExtent.height);
    }
    extent_ = {0, 0};
    if (extent.width == 0 || extent.height == 0) {
        isBroken_ = false;  // the window is hidden
        return {};
    }

    std::uint32_t imageCount = std::max(kWantedImages, surface.minImageCount);
    if (surface.maxImageCount > 0) imageCount = std::min(imageCount, surface.maxImageCount);
    VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    info.surface = surface_;
    info.minImageCount = imageCount;
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    info.preTransform = surface.currentTransform;
    info.compositeAlpha = (surface.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR)
                              ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    info.presentMode = mode_;
    info.clipped = VK_TRUE;
    info.oldSwapchain = swapchain_.get();
    VkSwapchainKHR handle = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateSwapchainKHR(device_->handle(), &info, nullptr, &handle);
        result < 0) {
        swapchain_.reset();  // retired all the same, and useless for the next try
        return device_->failed(result, Text("create the images of the window"));
    }
    swapchain_ = std::unique_ptr<VkSwapchainKHR_T, DestroySwapchain>(handle, {device_});

    std::uint32_t count = 0;
    VkResult result = vkGetSwapchainImagesKHR(device_->handle(), handle, &count, nullptr);
    images_.assign(count, VK_NULL_HANDLE);
    if (result >= 0) result = vkGetSwapchainImagesKHR(device_->handle(), handle, &count, images_.data());
    if (result < 0) return device_->failed(result, Text("get the images of the window"));
    rendered_.clear();
    slots_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
        MACULA_TRY(auto semaphore, makeSemaphore());
        rendered_.push_back(std::move(semaphore));
    }
    for (std::uint32_t i = 0; i <= count; ++i) {
        MACULA_TRY(auto semaphore, makeSemaphore());
        slots_.push_back({std::move(semaphore), 0});
    }
    nextSlot_ = 0;
    extent_ = extent;
    isBroken_ = false;
    device_->destroyUnused();
    return {};
}

// Width UINT32_MAX: the surface takes the size of the images.
Result<VkExtent2D> Swapchain::surfaceExtent() const {
    VkSurfaceCapabilitiesKHR surface{};
    const VkResult asked = vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_->physical(), surface_, &surface);
    if (asked < 0) return device_->failed(asked, Text("ask for the size of the window"));
    return surface.currentExtent;
}

Result<Swapchain::Frame> Swapchain::acquire(std::uint64_t timeoutNs) {
    const Text doing("get an image of the window");  // made before the call, as in Device::waitFor()
    MACULA_TRY_VOID(device_->checkNotLost(doing));
    Frame frame;
    if (isBroken_) {
        frame.status = Status::outOfDate;
        return frame;
    }
    if (extent_.width == 0) {
        MACULA_TRY(const VkExtent2D now, surfaceExtent());
        const bool isBack = now.width != UINT32_MAX && now.width > 0 && now.height > 0;
        frame.status = isBack ? Status::outOfDate : Status::hidden;
        return frame;
    }
    Slot& slot = slots_[nextSlot_];
    MACULA_TRY(const bool free, device_->waitFor(slot.usedBy, timeoutNs));
    if (!free) return frame;  // timeout

    // Mesa's software presentation on X11 silently continues after the window's size has changed.
    if (device_->isCpu()) {
        MACULA_TRY(const VkExtent2D now, surfaceExtent());
        if (now.width != UINT32_MAX && (now.width != extent_.width || now.height != extent_.height)) {
            frame.status = Status::outOfDate;
            return frame;
        }
    }

    const VkResult result = vkAcquireNextImageKHR(device_->handle(), swapchain_.get(), timeoutNs,
                                                  slot.available.get(), VK_NULL_HANDLE, &frame.index);
    if (result == VK_TIMEOUT || result == VK_NOT_READY) return frame;
    if (result == VK_ERROR_OUT_OF_DATE_KHR) {
        frame.status = Status::outOfDate;
        return frame;
    }
    if (result < 0) return device_->failed(result, doing);
    isBroken_ = true;  // until it is presented
    frame.status = result == VK_SUBOPTIMAL_KHR ? Status::suboptimal : Status::ready;
    frame.image = images_[frame.index];
    frame.extent = extent_;
    frame.available = slot.available.get();
    frame.rendered = rendered_[frame.index].get();
    currentSlot_ = nextSlot_;
    nextSlot_ = (nextSlot_ + 1) % slots_.size();
    return frame;
}

Result<Swapchain::Status> Swapchain::present(const Frame& frame, Ticket rendered) {
    MACULA_CHECK(frame.usable());
    const Text doing("show the image in the window");  // made before the call, as in Device::waitFor()
    MACULA_TRY_VOID(device_->checkNotLost(doing));
    slots_[currentSlot_].usedBy = rendered;
    const VkSwapchainKHR swapchain = swapchain_.get();
    VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &frame.rendered;
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain;
    info.pImageIndices = &frame.index;
    const VkResult result = vkQueuePresentKHR(device_->queue(), &info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return Status::outOfDate;
    if (result < 0) return device_->failed(result, doing);
    isBroken_ = false;
    return result == VK_SUBOPTIMAL_KHR ? Status::suboptimal : Status::ready;
}

}  // namespace macula::gpu
