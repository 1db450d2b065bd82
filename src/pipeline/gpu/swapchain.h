// The images of a window.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/handle.h"
#include "pipeline/gpu/recorder.h"

namespace macula::gpu {

enum class PresentMode {
    fifo,     // every frame is shown, at the rate of the display; always available
    mailbox,  // the newest frame is shown; fifo if the surface does not offer it
};

struct SwapchainOptions {
    VkExtent2D extent{};  // of the window in pixels; used if the surface leaves the choice
    PresentMode mode = PresentMode::fifo;
};

// Equivalent of VkSwapchainKHR and its semaphores, on a surface owned by the caller, who destroys it after
// this. The device needs VK_KHR_SWAPCHAIN_EXTENSION_NAME. The format is B8G8R8A8 or R8G8B8A8 UNORM, shown as
// sRGB: what is blitted in must be display-encoded. Thread rule as for Device.
//
//   MACULA_TRY(auto frame, swapchain.acquire());
//   if (frame.status == outOfDate) resize, else if not timeout:
//   recorder.blit(image, frame.target());
//   MACULA_TRY(auto ticket, recorder.submit({.wait = frame.available, .signal = frame.rendered}));
//   MACULA_TRY(auto status, swapchain.present(frame, ticket));
class Swapchain {
  public:
    enum class Status {
        ready,
        suboptimal,  // works, but the window has changed: resize soon
        outOfDate,   // resize, then try again
        timeout,     // no image yet (acquire only)
        hidden,      // the window has no pixels now (minimised): try again later
    };

    struct Frame {
        Status status = Status::timeout;  // the other members are valid only for ready and suboptimal
        std::uint32_t index = 0;
        VkImage image = VK_NULL_HANDLE;
        VkExtent2D extent{};
        VkSemaphore available = VK_NULL_HANDLE;
        VkSemaphore rendered = VK_NULL_HANDLE;

        bool usable() const { return status == Status::ready || status == Status::suboptimal; }
        BlitTarget target() const { return {image, extent}; }
    };

    // Fails with deviceNotUsable when the device cannot present on the surface, or the surface is lost.
    static Result<Swapchain> create(const std::shared_ptr<Device>& device, VkSurfaceKHR surface,
                                    const SwapchainOptions& options);

    // Waits for the device. Afterwards extent() is the size that the surface allows; 0 x 0 while the window
    // is hidden.
    Result<void> resize(VkExtent2D extent);

    // A usable frame must be submitted (waiting for `available`, signalling `rendered`) and presented. If
    // that or resize() fails, the next frame is outOfDate, because the images have to be made again.
    Result<Frame> acquire(std::uint64_t timeoutNs = kForever);
    Result<Status> present(const Frame& frame, Ticket rendered);

    VkExtent2D extent() const { return extent_; }
    VkFormat format() const { return format_.format; }

  private:
    struct Slot {
        Handle<VkSemaphore> available;
        Ticket usedBy = 0;  // once this submission is done, `available` may be reused
    };

    // Destroys at once instead of later: the caller may destroy the surface right after.
    struct DestroySwapchain {
        std::shared_ptr<Device> device;
        void operator()(VkSwapchainKHR swapchain) const;
    };

    Swapchain() = default;
    Result<Handle<VkSemaphore>> makeSemaphore() const;
    Result<VkExtent2D> surfaceExtent() const;

    std::shared_ptr<Device> device_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    VkSurfaceFormatKHR format_{};
    VkPresentModeKHR mode_ = VK_PRESENT_MODE_FIFO_KHR;
    VkExtent2D extent_{};
    bool isBroken_ = false;  // a resize was not finished, or an image was acquired and not presented
    std::unique_ptr<VkSwapchainKHR_T, DestroySwapchain> swapchain_;
    std::vector<VkImage> images_;
    std::vector<Handle<VkSemaphore>> rendered_;  // one per image
    std::vector<Slot> slots_;                    // one more than images
    std::size_t nextSlot_ = 0;
    std::size_t currentSlot_ = 0;
};

}  // namespace macula::gpu
