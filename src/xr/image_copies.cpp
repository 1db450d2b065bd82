#include "xr/image_copies.h"

#include <vulkan/vulkan.h>

#include <vector>

#include "base/check.h"

namespace macula::xr {

namespace {

void moveLayer(VkCommandBuffer commands, const gpu::LentLayer& layer, VkImageAspectFlags aspect,
               VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = layer.image;
    barrier.subresourceRange = {aspect, 0, 1, layer.layer, 1};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace

void copyVisible(gpu::Recorder& recorder, const gpu::Image& from, const glm::ivec2& firstPx,
                 std::span<const VisiblePart> parts, const gpu::LentLayer& to) {
    constexpr VkImageAspectFlags kColour = VK_IMAGE_ASPECT_COLOR_BIT;
    recorder.barrier();
    VkCommandBuffer commands = recorder.commands();
    moveLayer(commands, to, kColour, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkClearColorValue nothing{};
    const VkImageSubresourceRange range{kColour, 0, 1, to.layer, 1};
    vkCmdClearColorImage(commands, to.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &nothing, 1, &range);
    moveLayer(commands, to, kColour, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    std::vector<VkImageCopy> regions;
    for (const VisiblePart& part : parts) {
        const glm::ivec2 at = firstPx + part.firstPx;
        MACULA_CHECK(at.x >= 0 && at.y >= 0 && part.sizePx.x > 0 && part.sizePx.y > 0);
        MACULA_CHECK_LE(at.x + part.sizePx.x, static_cast<int>(from.extent().width));
        MACULA_CHECK_LE(at.y + part.sizePx.y, static_cast<int>(from.extent().height));
        regions.push_back(
            {{kColour, 0, 0, 1},
             {at.x, at.y, 0},
             {kColour, 0, to.layer, 1},
             {part.firstPx.x, part.firstPx.y, 0},
             {static_cast<std::uint32_t>(part.sizePx.x), static_cast<std::uint32_t>(part.sizePx.y), 1}});
    }
    if (!regions.empty())
        vkCmdCopyImage(commands, from.handle(), VK_IMAGE_LAYOUT_GENERAL, to.image,
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, static_cast<std::uint32_t>(regions.size()),
                       regions.data());
    moveLayer(commands, to, kColour, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, to.layout);
    recorder.barrier();
}

void copyDepths(gpu::Recorder& recorder, const gpu::Buffer& from, int rowPx, const glm::ivec2& firstPx,
                const glm::ivec2& partPx, const gpu::LentLayer& to) {
    constexpr VkImageAspectFlags kDepth = VK_IMAGE_ASPECT_DEPTH_BIT;
    MACULA_CHECK(firstPx.x >= 0 && firstPx.y >= 0 && partPx.x > 0 && partPx.y > 0);
    MACULA_CHECK_LE(firstPx.x + partPx.x, rowPx);
    MACULA_CHECK_LE(std::uint64_t(firstPx.y + partPx.y) * std::uint64_t(rowPx) * sizeof(float), from.bytes());
    recorder.barrier();
    VkCommandBuffer commands = recorder.commands();
    moveLayer(commands, to, kDepth, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy region{};
    region.bufferOffset =
        (std::uint64_t(firstPx.y) * std::uint64_t(rowPx) + std::uint64_t(firstPx.x)) * sizeof(float);
    region.bufferRowLength = static_cast<std::uint32_t>(rowPx);
    region.imageSubresource = {kDepth, 0, to.layer, 1};
    region.imageExtent = {static_cast<std::uint32_t>(partPx.x), static_cast<std::uint32_t>(partPx.y), 1};
    vkCmdCopyBufferToImage(commands, from.handle(), to.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                           &region);
    moveLayer(commands, to, kDepth, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, to.layout);
    recorder.barrier();
}

bool drawsOnQueue(const gpu::Device& device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, families.data());
    return device.queueFamily() < count &&
           (families[device.queueFamily()].queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;
}

}  // namespace macula::xr
