#include "pipeline/gpu/foreign_images.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/check.h"

namespace macula::gpu {

namespace {

constexpr VkImageSubresourceLayers kFirstLayer{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};

VkImageMemoryBarrier2 imageBarrier(VkImage image, std::uint32_t layer, VkImageLayout from, VkImageLayout to,
                                   VkAccessFlags2 access) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = access;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, layer, 1};
    return barrier;
}

void record(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier) {
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

void moveLayout(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to,
                VkAccessFlags2 access, std::uint32_t layer = 0) {
    record(commands, imageBarrier(image, layer, from, to, access));
}

// Releases the layer to another device, which must acquire it with the same layouts. Macula never acquired it
// from there, so its previous content is lost.
void release(VkCommandBuffer commands, const LentLayer& layer, std::uint32_t queueFamily) {
    VkImageMemoryBarrier2 barrier =
        imageBarrier(layer.image, layer.layer, layer.layout, layer.layout, VK_ACCESS_2_NONE);
    barrier.srcQueueFamilyIndex = queueFamily;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_EXTERNAL;
    record(commands, barrier);
}

// The blit of a part of the source to a place in the target; nothing if the part lies outside the target.
std::optional<VkImageBlit> placed(const VkRect2D& part, VkOffset2D place, VkExtent2D target) {
    // The visible part, along one axis.
    struct Span {
        std::int32_t begin;
        std::int32_t end;
    };
    const auto within = [](std::int32_t at, std::uint32_t length, std::uint32_t most) {
        const std::int64_t begin = std::max<std::int64_t>(-std::int64_t{at}, 0);
        const std::int64_t end = std::min<std::int64_t>(length, std::int64_t{most} - at);
        return begin < end ? Span{std::int32_t(begin), std::int32_t(end)} : Span{0, 0};
    };
    const Span x = within(place.x, part.extent.width, target.width);
    const Span y = within(place.y, part.extent.height, target.height);
    if (x.begin == x.end || y.begin == y.end) return std::nullopt;
    const auto region = [&](VkOffset2D from, std::int32_t atX, std::int32_t atY, std::int32_t z) {
        return VkOffset3D{from.x + atX, from.y + atY, z};
    };
    return VkImageBlit{kFirstLayer,
                       {region(part.offset, x.begin, y.begin, 0), region(part.offset, x.end, y.end, 1)},
                       kFirstLayer,
                       {region(place, x.begin, y.begin, 0), region(place, x.end, y.end, 1)}};
}

std::vector<VkImageBlit> partsOf(const BlitOverlay& overlay, VkExtent2D target) {
    std::vector<VkImageBlit> parts;
    MACULA_CHECK(overlay.places.empty() || overlay.places.size() == overlay.parts.size());
    for (std::size_t i = 0; i < overlay.parts.size(); ++i) {
        const VkRect2D& part = overlay.parts[i];
        MACULA_CHECK(overlay.image != nullptr && part.offset.x >= 0 && part.offset.y >= 0);
        MACULA_CHECK_LE(std::uint64_t(part.offset.x) + part.extent.width, overlay.image->extent().width);
        MACULA_CHECK_LE(std::uint64_t(part.offset.y) + part.extent.height, overlay.image->extent().height);
        const VkOffset2D place = overlay.places.empty() ? part.offset : overlay.places[i];
        if (const auto region = placed(part, place, target)) parts.push_back(*region);
    }
    return parts;
}

}  // namespace

void recordCopy(VkCommandBuffer commands, const Image& from, const VkRect2D& part, const LentLayer& to,
                std::uint32_t queueFamily) {
    MACULA_CHECK(from.shape() == ImageShape::flat && part.offset.x >= 0 && part.offset.y >= 0);
    MACULA_CHECK_LE(std::uint64_t(part.offset.x) + part.extent.width, from.extent().width);
    MACULA_CHECK_LE(std::uint64_t(part.offset.y) + part.extent.height, from.extent().height);
    moveLayout(commands, to.image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
               VK_ACCESS_2_TRANSFER_WRITE_BIT, to.layer);
    const VkImageCopy region{kFirstLayer,
                             {part.offset.x, part.offset.y, 0},
                             {VK_IMAGE_ASPECT_COLOR_BIT, 0, to.layer, 1},
                             {0, 0, 0},
                             {part.extent.width, part.extent.height, 1}};
    vkCmdCopyImage(commands, from.handle(), VK_IMAGE_LAYOUT_GENERAL, to.image,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    moveLayout(commands, to.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, to.layout,
               VK_ACCESS_2_MEMORY_READ_BIT, to.layer);
    if (to.isExternal) release(commands, to, queueFamily);
}

void recordBlit(VkCommandBuffer commands, const Image& from, const BlitTarget& to, VkFilter filter,
                std::span<const BlitOverlay> overlays) {
    MACULA_CHECK(from.shape() == ImageShape::flat);
    moveLayout(commands, to.image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
               VK_ACCESS_2_TRANSFER_WRITE_BIT);
    VkImageBlit region{};
    region.srcSubresource = kFirstLayer;
    region.srcOffsets[1] = {static_cast<std::int32_t>(from.extent().width),
                            static_cast<std::int32_t>(from.extent().height), 1};
    region.dstSubresource = kFirstLayer;
    region.dstOffsets[1] = {static_cast<std::int32_t>(to.extent.width),
                            static_cast<std::int32_t>(to.extent.height), 1};
    vkCmdBlitImage(commands, from.handle(), VK_IMAGE_LAYOUT_GENERAL, to.image,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, filter);
    for (const BlitOverlay& overlay : overlays) {
        const std::vector<VkImageBlit> parts = partsOf(overlay, to.extent);
        if (parts.empty()) continue;
        moveLayout(commands, to.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_ACCESS_2_TRANSFER_WRITE_BIT);
        vkCmdBlitImage(commands, overlay.image->handle(), VK_IMAGE_LAYOUT_GENERAL, to.image,
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, static_cast<std::uint32_t>(parts.size()),
                       parts.data(), VK_FILTER_NEAREST);
    }
    moveLayout(commands, to.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, 0);
}

}  // namespace macula::gpu
