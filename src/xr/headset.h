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
#include "xr/eye_copy.h"
#include "xr/hands.h"
#include "xr/quad_layers.h"
#include "xr/room_controls.h"
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
    // is. `controls`: what hands have chosen so far, of a session before; null: nothing.
    static Result<Headset> open(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
                                RoomView& view, const std::optional<glm::dmat4>& placed = {},
                                std::shared_ptr<RoomControls> controls = nullptr);

    // A frame: waits for its time, draws, submits, and uses what is left of its time for what will be better
    // in later ones. A frame that was begun is submitted, also when drawing fails.
    Result<Step> step();
    // Steps go on until one says ended.
    Result<void> requestEnd() { return session_.requestEnd(); }

    const std::optional<glm::dmat4>& placed() const { return stageFromWorld_; }
    const std::optional<Shown>& shown() const { return shown_; }
    const RoomControls& controls() const { return *controls_; }

  private:
    struct Views {
        std::vector<XrCompositionLayerProjectionView> eyes;
        std::vector<XrCompositionLayerQuad> quads;
    };

    Headset(Session session, Hands hands, Swapchains swapchains, RoomView& view,
            const std::optional<glm::dmat4>& placed, std::shared_ptr<RoomControls> controls)
        : session_(std::move(session)),
          hands_(std::move(hands)),
          swapchains_(std::move(swapchains)),
          quads_(session_),
          copy_(session_.device()),
          view_(&view),
          controls_(std::move(controls)),
          stageFromWorld_(placed) {}
    Result<Views> draw(const FrameTime& time);
    Result<RoomFollowed> follow(const FrameTime& time, const Pose& head, const TwoHands& hands,
                                bool isTracked);
    Result<void> copyForOthers(const FrameTime& time, const Shown& shown);

    Session session_;
    Hands hands_;            // dropped before the session
    Swapchains swapchains_;  // likewise
    QuadLayers quads_;       // likewise
    EyeCopy copy_;
    std::unique_ptr<PictureWriter> writer_ = std::make_unique<PictureWriter>();
    RoomView* view_;
    std::shared_ptr<RoomControls> controls_;
    bool wantsPicture_ = false;
    bool copiesForPicture_ = false;  // what is under way
    XrTime mirroredAt_ = 0;
    std::optional<glm::dmat4> stageFromWorld_;
    std::optional<Shown> shown_;
};

}  // namespace macula::xr
