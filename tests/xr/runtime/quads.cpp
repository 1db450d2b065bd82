// Flat layers, and what was left in them.
#include <cmath>

#include "xr/runtime/state.h"

namespace macula::xr_script {

XrResult takeQuad(const XrCompositionLayerQuad& quad, SubmittedFrame& frame) {
    State& all = state();
    if (!all.spaces.contains(quad.space))
        return wrong(XR_ERROR_HANDLE_INVALID, "xrEndFrame: the space of a flat layer");
    const auto found = all.swapchains.find(quad.subImage.swapchain);
    if (found == all.swapchains.end())
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: the swapchain of a flat layer");
    const SwapchainState& swapchain = *found->second;
    if (isDepth(swapchain)) return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: a flat layer of depths");
    const XrRect2Di& rect = quad.subImage.imageRect;
    if (!swapchain.released || !swapchain.acquired.empty())
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: the image of a flat layer was not released");
    if (rect.offset.x < 0 || rect.offset.y < 0 || rect.extent.width <= 0 || rect.extent.height <= 0 ||
        std::uint32_t(rect.offset.x + rect.extent.width) > swapchain.info.width ||
        std::uint32_t(rect.offset.y + rect.extent.height) > swapchain.info.height ||
        quad.subImage.imageArrayIndex >= swapchain.info.arraySize)
        return wrong(XR_ERROR_SWAPCHAIN_RECT_INVALID, "xrEndFrame: a flat layer lies beside its image");
    const Pose pose = toPose(quad.pose);
    if (!(std::abs(glm::length(pose.orientation) - 1.0) < 0.01))
        return wrong(XR_ERROR_POSE_INVALID, "xrEndFrame: the pose of a flat layer");
    if (!(quad.size.width > 0.0f && quad.size.height > 0.0f))
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: the size of a flat layer");
    frame.quads.push_back({pose,
                           {double(quad.size.width), double(quad.size.height)},
                           {rect.extent.width, rect.extent.height},
                           all.script.keepsPictures
                               ? readImage(swapchain, quad.subImage.imageArrayIndex, rect)
                               : std::vector<glm::u8vec4>()});
    return XR_SUCCESS;
}

}  // namespace macula::xr_script
