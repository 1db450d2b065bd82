// Flat pictures in the room, which the headset's software composes at its own rate (XrCompositionLayerQuad):
// letters stay sharp, however coarse the anatomy is.
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
