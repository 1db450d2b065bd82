#include "xr/swapchains.h"

#include <vulkan/vulkan.h>
#include <cmath>
#include <utility>
#include <vector>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "xr/placement.h"
#include "xr/xr_error.h"

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

bool isAllOf(std::span<const VisiblePart> parts, const glm::ivec2& sizePx) {
    return parts.size() == 1 && parts[0] == VisiblePart{glm::ivec2(0), sizePx};
}

constexpr LentImages::Kind kDepths{.format = VK_FORMAT_D32_SFLOAT,
                                   .usage = XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT |
                                            XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT |
                                            XR_SWAPCHAIN_USAGE_SAMPLED_BIT,
                                   .layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};

// Copies `parts` of the picture whose upper left corner is at `firstPx`, bit by bit; the rest of the layer
// becomes black and transparent.
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

// Copies the part of size `partPx` at `firstPx`, from depths in rows of `rowPx`, to a depth layer
// (D32_SFLOAT). The device's queue must be a graphics queue (drawsOnQueue).
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

// Whether the device's queue is a graphics queue, which copying of depths needs.
bool drawsOnQueue(const gpu::Device& device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, families.data());
    return device.queueFamily() < count &&
           (families[device.queueFamily()].queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;
}

}  // namespace

Result<Swapchains> Swapchains::create(const Session& session, const glm::ivec2& sizePx) {
    MACULA_TRY(auto pair, SwapchainPair::create(session, sizePx, LentImages::kColours));
    if (!pair)
        return Error{ErrorCode::deviceNotUsable,
                     Text("The headset takes no pictures of 8 bits in sRGB (R8G8B8A8_SRGB)."), "",
                     Text("Update the software of the headset.")};
    return Swapchains(std::move(*pair));
}

Result<void> Swapchains::copy(const EyePictures& eyes, std::span<const gpu::Image* const> pictures,
                              std::span<const std::vector<VisiblePart>> visible) {
    MACULA_TRY(auto recorder, gpu::Recorder::create(pair_.device(), "copy to the headset"));
    for (std::size_t eye = 0; eye < pictures.size(); ++eye) {
        const EyePicture& shown = eyes.eyes[eye];
        if (eye < visible.size() && !isAllOf(visible[eye], shown.partPx)) {
            copyVisible(recorder, *pictures[eye], shown.firstPx, visible[eye], pair_.image(eye));
            continue;
        }
        recorder.copy(
            *pictures[eye],
            {{shown.firstPx.x, shown.firstPx.y},
             {static_cast<std::uint32_t>(shown.partPx.x), static_cast<std::uint32_t>(shown.partPx.y)}},
            pair_.image(eye));
    }
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return {};
}

Result<std::vector<XrCompositionLayerProjectionView>> Swapchains::show(
    const EyePictures& eyes, std::span<const gpu::Image* const> pictures,
    std::span<const std::vector<VisiblePart>> visible) {
    MACULA_CHECK_EQ(pictures.size(), SwapchainPair::kViews);
    MACULA_CHECK_EQ(eyes.eyes.size(), SwapchainPair::kViews);
    MACULA_TRY_VOID(pair_.acquire());
    const Result<void> copied = copy(eyes, pictures, visible);
    // Released even after an error: the next frame needs the images.
    MACULA_TRY_VOID(pair_.release());
    if (!copied) return copied.error();

    std::vector<XrCompositionLayerProjectionView> views;
    for (std::size_t i = 0; i < eyes.eyes.size(); ++i) {
        const EyePicture& shown = eyes.eyes[i];
        XrCompositionLayerProjectionView view{XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW};
        view.pose = toXr(shown.eye.pose);
        const auto angle = [](double tangent) { return static_cast<float>(std::atan(tangent)); };
        view.fov = {angle(shown.eye.left), angle(shown.eye.right), angle(shown.eye.up),
                    angle(shown.eye.down)};
        view.subImage = pair_.part(i, shown.partPx);
        views.push_back(view);
    }
    return views;
}

hybrid::DepthRange depthRangeOf(const glm::dmat4& stageFromWorld) {
    return {.nearest = static_cast<float>(kNearM),
            .farthest = kFarM,
            .unitsPerMm = static_cast<float>(kMetresPerMm * scaleOf(stageFromWorld))};
}

Result<std::optional<DepthLayer>> DepthLayer::create(const Session& session, const glm::ivec2& sizePx) {
    if (!session.runtime().offer().takesDepth || !drawsOnQueue(*session.device()))
        return std::optional<DepthLayer>();
    MACULA_TRY(auto pair, SwapchainPair::create(session, sizePx, kDepths));
    if (!pair) return std::optional<DepthLayer>();
    return std::optional<DepthLayer>(DepthLayer(std::move(*pair)));
}

Result<void> DepthLayer::add(const EyePictures& eyes, std::span<const gpu::Buffer* const> depths,
                             std::span<XrCompositionLayerProjectionView> views) {
    MACULA_CHECK_EQ(depths.size(), SwapchainPair::kViews);
    MACULA_CHECK_EQ(views.size(), SwapchainPair::kViews);
    MACULA_TRY_VOID(pair_.acquire());
    const auto copy = [&]() -> Result<void> {
        MACULA_TRY(auto recorder, gpu::Recorder::create(pair_.device(), "depths to the headset"));
        for (std::size_t i = 0; i < depths.size(); ++i)
            copyDepths(recorder, *depths[i], eyes.sizePx.x, eyes.eyes[i].firstPx, eyes.eyes[i].partPx,
                       pair_.image(i));
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
        return {};
    };
    Result<void> copied = copy();
    MACULA_TRY_VOID(pair_.release());  // in any case
    if (!copied) return copied;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        XrCompositionLayerDepthInfoKHR& told = told_[i];
        told = {XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR};
        told.subImage = pair_.part(i, eyes.eyes[i].partPx);
        told.minDepth = 0.0f;
        told.maxDepth = 1.0f;
        told.nearZ = static_cast<float>(kNearM);
        told.farZ = kFarM;
        views[i].next = &told;
    }
    return {};
}

Result<void> QuadLayers::make(const Session& session, Sent& sent, const glm::ivec2& sizePx) {
    MACULA_TRY(auto images, LentImages::create(session, sizePx, 1, LentImages::kColours));
    MACULA_CHECK(images.has_value());
    gpu::ImageOptions options;
    options.label = "panel";
    options.width = static_cast<std::uint32_t>(sizePx.x);
    options.height = static_cast<std::uint32_t>(sizePx.y);
    options.format = VK_FORMAT_R8G8B8A8_UNORM;
    MACULA_TRY(sent.picture, gpu::Image::create(session.device(), options));
    sent.images.emplace(std::move(*images));
    return {};
}

Result<void> QuadLayers::send(Sent& sent, const PanelPicture& picture) {
    const gpu::Image& from = *sent.picture;
    MACULA_TRY_VOID(gpu::uploadTo(from, std::as_bytes(std::span(picture.pixels()))));
    MACULA_TRY_VOID(sent.images->acquire());
    const auto copy = [&]() -> Result<void> {
        MACULA_TRY(auto recorder, gpu::Recorder::create(from.device(), "panel for the headset"));
        recorder.copy(from, {{0, 0}, {from.extent().width, from.extent().height}}, sent.images->layer(0));
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
        return {};
    };
    Result<void> copied = copy();
    MACULA_TRY_VOID(sent.images->release());  // in any case
    return copied;
}

Result<std::vector<XrCompositionLayerQuad>> QuadLayers::show(const Session& session,
                                                             const RoomControls& controls,
                                                             std::span<const Floating> floating) {
    std::vector<XrCompositionLayerQuad> layers;
    for (const Floating& shown : floating) {
        Sent& sent = sent_.at(std::size_t(shown.picture));
        const PanelPicture& picture = controls.picture(shown.picture);
        if (!sent.images) MACULA_TRY_VOID(make(session, sent, picture.sizePx()));
        if (const std::uint64_t number = controls.pictureNumber(shown.picture); number != sent.number) {
            MACULA_TRY_VOID(send(sent, picture));
            sent.number = number;
        }
        XrCompositionLayerQuad layer{XR_TYPE_COMPOSITION_LAYER_QUAD};
        layer.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT |
                           XR_COMPOSITION_LAYER_UNPREMULTIPLIED_ALPHA_BIT;
        layer.space = session.stage();
        layer.eyeVisibility = XR_EYE_VISIBILITY_BOTH;
        layer.subImage = sent.images->part(0, picture.sizePx());
        layer.pose = toXr(shown.pose);
        layer.size = {static_cast<float>(shown.sizeM.x), static_cast<float>(shown.sizeM.y)};
        layers.push_back(layer);
    }
    return layers;
}

}  // namespace macula::xr
