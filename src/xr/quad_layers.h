// Flat pictures in the room, which the software of the headset puts before the eyes by itself, at its own
// pace (XrCompositionLayerQuad): letters stay sharp, however coarse the anatomy is.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/resources.h"
#include "xr/room_controls.h"
#include "xr/session.h"

namespace macula::xr {

// Must not outlive its session. Used by one thread at a time, the one that uses the device.
class QuadLayers {
  public:
    explicit QuadLayers(const Session& session)
        : runtime_(session.sharedRuntime()), device_(session.device()) {}
    QuadLayers(QuadLayers&& other) noexcept;
    QuadLayers& operator=(QuadLayers&&) = delete;
    ~QuadLayers();

    // Layers of the stage for what floats. Pictures are sent when they are seen first, and when they have
    // changed.
    Result<std::vector<XrCompositionLayerQuad>> show(const Session& session, const RoomControls& controls,
                                                     std::span<const Floating> floating);

  private:
    struct Chain {
        XrSwapchain handle = XR_NULL_HANDLE;
        std::vector<VkImage> images;
        std::optional<gpu::Image> picture;
        std::uint64_t number = 0;  // of the picture that was sent last
    };

    Result<void> make(const Session& session, Chain& chain, const glm::ivec2& sizePx);
    Result<void> send(Chain& chain, const PanelPicture& picture);

    std::shared_ptr<Runtime> runtime_;
    std::shared_ptr<gpu::Device> device_;
    std::array<Chain, kRoomPictures> chains_;
};

}  // namespace macula::xr
