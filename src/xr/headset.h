// A study in a headset, frame by frame.
//
//   MACULA_TRY(Headset headset, Headset::open(runtime, device, view));
//   while (true) { MACULA_TRY(const auto step, headset.step()); if (step == ended) break; }
//
// When a step fails with deviceLost drop it. Where the session was lost another one may be opened for the
// same view, and with `placed` everything stands where it stood; when the software of the headset is gone,
// runtime, device and view are made anew as well, of the view's scene.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "xr/hands.h"
#include "xr/room_view.h"
#include "xr/session.h"
#include "xr/swapchains.h"

namespace macula::xr {

// Used by one thread, the one that uses the device.
class Headset {
  public:
    enum class Step {
        waiting,  // nobody wears it: come again after a while
        empty,    // a frame without pictures was submitted
        shown,
        ended,
    };
    // What was shown last.
    struct Shown {
        EyePictures eyes;
        hybrid::Frame frame;  // its pictures are valid until the next step
        glm::dvec2 gaze{0.0};
        XrTime displayed = 0;
    };

    // `view` outlives it. `placed`: stageFromWorld; nothing: before who wears it, once it is known where that
    // is.
    static Result<Headset> open(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
                                RoomView& view, const std::optional<glm::dmat4>& placed = {});

    // A frame: waits for its time, draws, submits, and uses what is left of its time for what will be better
    // in later ones. A frame that was begun is submitted, also when drawing fails.
    Result<Step> step();
    // Steps go on until one says ended.
    Result<void> requestEnd() { return session_.requestEnd(); }

    const std::optional<glm::dmat4>& placed() const { return stageFromWorld_; }
    const std::optional<Shown>& shown() const { return shown_; }

  private:
    using Views = std::vector<XrCompositionLayerProjectionView>;

    Headset(Session session, Hands hands, Swapchains swapchains, RoomView& view,
            const std::optional<glm::dmat4>& placed)
        : session_(std::move(session)),
          hands_(std::move(hands)),
          swapchains_(std::move(swapchains)),
          view_(&view),
          stageFromWorld_(placed) {}
    Result<Views> draw(const FrameTime& time);
    Result<void> useHands(const TwoHands& hands);

    Session session_;
    Hands hands_;            // dropped before the session
    Swapchains swapchains_;  // likewise
    RoomView* view_;
    Grasp grasp_;
    std::optional<glm::dmat4> stageFromWorld_;
    std::optional<Shown> shown_;
};

}  // namespace macula::xr
