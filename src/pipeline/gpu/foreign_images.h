// Commands that write to images of other owners: of a window, of a headset, of another device.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <span>

#include "pipeline/gpu/resources.h"

namespace macula::gpu {

// Parts of an image to draw over a blitted one; whatever lies outside the target is left out.
struct BlitOverlay {
    const Image* image = nullptr;  // null: no overlay
    std::span<const VkRect2D> parts;
    std::span<const VkOffset2D> places = {};  // of each part in the target; empty: as in its own image
};

struct BlitTarget {  // see Swapchain::Frame::target()
    VkImage image = VK_NULL_HANDLE;
    VkExtent2D extent{};
};

// A layer of an image of another owner, and the layout in which the owner wants it back: xr/swapchains.h,
// shared_image.h.
struct LentLayer {
    VkImage image = VK_NULL_HANDLE;
    std::uint32_t layer = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    bool isExternal = false;  // the owner uses another device: released to VK_QUEUE_FAMILY_EXTERNAL
};

// Record what Recorder::copy and Recorder::blit do. The caller has recorded a barrier before.
void recordCopy(VkCommandBuffer commands, const Image& from, const VkRect2D& part, const LentLayer& to,
                std::uint32_t queueFamily);
void recordBlit(VkCommandBuffer commands, const Image& from, const BlitTarget& to, VkFilter filter,
                std::span<const BlitOverlay> overlays);

}  // namespace macula::gpu
