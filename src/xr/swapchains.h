// The layers that the headset shows: pictures of both eyes or of both insets, their depths, and flat
// pictures.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/hybrid/frame/eye_depths.h"
#include "xr/eyes.h"
#include "xr/lent_images.h"
#include "xr/room_controls.h"
#include "xr/session.h"
#include "xr/visibility_mask.h"

namespace macula::xr {

// Must not outlive its session. Used by one thread at a time, the one that uses the device.
class Swapchains {
  public:
    // For pictures of at most that size. R8G8B8A8_SRGB: our pictures are encoded already, and are copied bit
    // by bit. deviceNotUsable if the runtime does not support it.
    static Result<Swapchains> create(const Session& session, const glm::ivec2& sizePx);

    // Waits until the runtime lends the images. Called before the eyes are located, because it may take a
    // while.
    Result<void> acquire() { return pair_.acquire(); }
    // Copies each eye's part of its picture, and returns the views of the layer. `visible`: the visible areas
    // of each part (bandsOf); the rest becomes black and transparent. Empty: everything is visible. Waits for
    // the runtime, but not for drawing.
    Result<std::vector<XrCompositionLayerProjectionView>> show(
        const EyePictures& eyes, std::span<const gpu::Image* const> pictures,
        std::span<const std::vector<VisiblePart>> visible = {});

    const glm::ivec2& sizePx() const { return pair_.sizePx(); }
    std::size_t count() const { return pair_.count(); }

  private:
    explicit Swapchains(SwapchainPair pair) : pair_(std::move(pair)) {}
    Result<void> copy(const EyePictures& eyes, std::span<const gpu::Image* const> pictures,
                      std::span<const std::vector<VisiblePart>> visible);

    SwapchainPair pair_;
};

inline constexpr float kFarM = 100.0f;
// In metres of the room, for anatomy at this position and scale.
hybrid::DepthRange depthRangeOf(const glm::dmat4& stageFromWorld);

// The depths of two views, for the headset's software, which reprojects the pictures to where the eyes are by
// then, and shows hands and walls before or behind the anatomy (XR_KHR_composition_layer_depth). Must not
// outlive its session. Used by one thread at a time, the one that uses the device.
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

// Flat pictures in the room, which the headset's software composes at its own rate (XrCompositionLayerQuad):
// letters stay sharp, however coarse the anatomy is. Must not outlive its session. Used by one thread at a
// time, the one that uses the device.
class QuadLayers {
  public:
    // The layers of the floating pictures, in the stage. Uploads a picture when it is first shown, and when
    // it has changed.
    Result<std::vector<XrCompositionLayerQuad>> show(const Session& session, const RoomControls& controls,
                                                     std::span<const Floating> floating);

  private:
    struct Sent {
        std::optional<LentImages> images;
        std::optional<gpu::Image> picture;
        std::uint64_t number = 0;  // number of the last uploaded picture
    };

    static Result<void> make(const Session& session, Sent& sent, const glm::ivec2& sizePx);
    static Result<void> send(Sent& sent, const PanelPicture& picture);

    std::array<Sent, kRoomPictures> sent_;
};

}  // namespace macula::xr
