// Flat pictures in the room, which the software of the headset puts before the eyes by itself, at its own
// pace (XrCompositionLayerQuad): letters stay sharp, however coarse the anatomy is.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/resources.h"
#include "xr/lent_images.h"
#include "xr/room_controls.h"
#include "xr/session.h"

namespace macula::xr {

// Must not outlive its session. Used by one thread at a time, the one that uses the device.
class QuadLayers {
  public:
    // Layers of the stage for what floats. Pictures are sent when they are seen first, and when they have
    // changed.
    Result<std::vector<XrCompositionLayerQuad>> show(const Session& session, const RoomControls& controls,
                                                     std::span<const Floating> floating);

  private:
    struct Sent {
        std::optional<LentImages> images;
        std::optional<gpu::Image> picture;
        std::uint64_t number = 0;  // of the picture that was sent last
    };

    static Result<void> make(const Session& session, Sent& sent, const glm::ivec2& sizePx);
    static Result<void> send(Sent& sent, const PanelPicture& picture);

    std::array<Sent, kRoomPictures> sent_;
};

}  // namespace macula::xr
