// Commands that write images that others own: those of a window, of a headset, of another device.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <span>

#include "pipeline/gpu/resources.h"

namespace macula::gpu {

// Parts of an image that are laid over a blitted one; what lies outside of the target is left out.
struct BlitOverlay {
    const Image* image = nullptr;  // null: nothing
    std::span<const VkRect2D> parts;
    std::span<const VkOffset2D> places = {};  // of each in the target; empty: where it is in its own image
};

struct BlitTarget {  // Swapchain::Frame::target()
    VkImage image = VK_NULL_HANDLE;
    VkExtent2D extent{};
};

// A layer of an image that others own, and the layout in which they want it back: xr/swapchains.h,
// shared_image.h.
struct LentLayer {
    VkImage image = VK_NULL_HANDLE;
    std::uint32_t layer = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    bool isExternal = false;  // they own it on another device: it is released to VK_QUEUE_FAMILY_EXTERNAL
};

// As Recorder::copy and Recorder::blit, after all that was recorded before; the caller has put a barrier.
void recordCopy(VkCommandBuffer commands, const Image& from, const VkRect2D& part, const LentLayer& to,
                std::uint32_t queueFamily);
void recordBlit(VkCommandBuffer commands, const Image& from, const BlitTarget& to, VkFilter filter,
                std::span<const BlitOverlay> overlays);

}  // namespace macula::gpu
