// The depths of the pictures, for the headset's software, which reprojects the pictures to where the eyes are
// by then, and shows hands and walls before or behind the anatomy (XR_KHR_composition_layer_depth).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/hybrid/frame/eye_depths.h"
#include "xr/eyes.h"
#include "xr/session.h"
#include "xr/swapchain_pair.h"

namespace macula::xr {

inline constexpr float kFarM = 100.0f;
// In metres of the room, for anatomy at this position and scale.
hybrid::DepthRange depthRangeOf(const glm::dmat4& stageFromWorld);

// The depths of two views. Must not outlive its session. Used by one thread at a time, the one that uses the
// device.
class DepthLayer {
  public:
    // Nothing if the runtime takes no depths in D32_SFLOAT, or the device cannot copy them.
    static Result<std::optional<DepthLayer>> create(const Session& session, const glm::ivec2& sizePx);

    Result<void> acquire() { return pair_.acquire(); }
    // Copies each eye's part of the depths, and chains their description to `views`, which belong to the same
    // eyes: valid until the next call. `depths`: its rows are as wide as the whole picture.
    Result<void> add(const EyePictures& eyes, std::span<const gpu::Buffer* const> depths,
                     std::span<XrCompositionLayerProjectionView> views);

  private:
    explicit DepthLayer(SwapchainPair pair) : pair_(std::move(pair)) {}

    SwapchainPair pair_;
    std::array<XrCompositionLayerDepthInfoKHR, SwapchainPair::kViews> told_{};
};

}  // namespace macula::xr
