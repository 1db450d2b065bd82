#include "xr/depth_layer.h"

#include <utility>

#include "base/check.h"
#include "xr/image_copies.h"
#include "xr/placement.h"

namespace macula::xr {

namespace {

constexpr LentImages::Kind kDepths{.format = VK_FORMAT_D32_SFLOAT,
                                   .usage = XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT |
                                            XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT |
                                            XR_SWAPCHAIN_USAGE_SAMPLED_BIT,
                                   .layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};

}  // namespace

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

}  // namespace macula::xr
