// The pictures that the headset shows: of both eyes, or of both insets.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "xr/eyes.h"
#include "xr/session.h"
#include "xr/swapchain_pair.h"

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

}  // namespace macula::xr
