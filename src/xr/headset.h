// A study in a headset, frame by frame.
//
//   MACULA_TRY(Headset headset, Headset::open(runtime, device, view));
//   while (true) { MACULA_TRY(const auto step, headset.step()); if (step == ended) break; }
//
// When a step fails with deviceLost, drop it. If only the session was lost, open another one for the same
// view; with `placed` everything stands where it stood. If the headset's software has ended, make runtime,
// device and view again as well, from the view's scene.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "xr/eye_copy.h"
#include "xr/eye_masks.h"
#include "xr/frame_statistics.h"
#include "xr/governor.h"
#include "xr/hands.h"
#include "xr/room_controls.h"
#include "xr/room_view.h"
#include "xr/session.h"
#include "xr/swapchains.h"

namespace macula::xr {

struct HeadsetOptions {
    SessionOptions session = {};
    glm::ivec2 eyePx{0};    // size of each eye's picture; 0: as the headset recommends
    bool holdsRate = true;  // false: never lowers the quality for late frames
};

// Used by one thread, the one that uses the device.
class Headset {
  public:
    enum class Step {
        waiting,  // nobody wears it: call again after a while
        empty,    // a frame without pictures was submitted
        shown,
        ended,
    };
    // The last pictures shown.
    struct Shown {
        EyePictures eyes;
        std::optional<EyePictures> insets;  // if the headset has them; smaller and finer
        hybrid::Frame frame;                // its pictures (eyes, then insets) are valid until the next step
        glm::dvec2 gaze{0.0};   // in the centre eye's picture; without eye tracking, the insets' middle
        double fineness = 1.0;  // pixel density of insets over that of eyes
        XrTime displayed = 0;
    };

    // `view` outlives it. `placed`: stageFromWorld; nothing: in front of the wearer, once the head's position
    // is known. `controls`: the choices of an earlier session; null: none.
    static Result<Headset> open(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
                                RoomView& view, const std::optional<glm::dmat4>& placed = {},
                                const HeadsetOptions& options = {},
                                std::shared_ptr<RoomControls> controls = nullptr);

    // One frame: waits for its time, draws, submits, and uses the rest of its time to improve later frames. A
    // frame that was begun is always submitted, even when drawing fails.
    Result<Step> step();
    // Call step() until it returns ended.
    Result<void> requestEnd() { return session_.requestEnd(); }

    const std::optional<glm::dmat4>& placed() const { return stageFromWorld_; }
    const std::optional<Shown>& shown() const { return shown_; }
    // The times of the last submitted frame.
    const FrameTimes& times() const { return times_; }
    const Governor& governor() const { return governor_; }
    const Session& session() const { return session_; }
    // The largest size of the picture for each eye.
    const glm::ivec2& eyePx() const { return lent_.eyes.sizePx(); }
    const RoomControls& controls() const { return *controls_; }

  private:
    struct Views {
        std::vector<XrCompositionLayerProjectionView> eyes;
        std::vector<XrCompositionLayerQuad> quads;
    };

    // The images that the headset lends: destroyed before the session.
    struct Lent {
        Swapchains eyes;
        std::optional<Swapchains> insets;
        std::optional<DepthLayer> depths;  // for `eyes`
        std::optional<DepthLayer> insetDepths;
    };

    Headset(Session session, Hands hands, Lent lent, RoomView& view, const std::optional<glm::dmat4>& placed,
            bool holdsRate, std::shared_ptr<RoomControls> controls)
        : session_(std::move(session)),
          hands_(std::move(hands)),
          lent_(std::move(lent)),
          copy_(session_.device()),
          view_(&view),
          controls_(std::move(controls)),
          holdsRate_(holdsRate),
          stageFromWorld_(placed) {}
    static Result<Lent> lend(const Session& session, const HeadsetOptions& options);
    Result<Views> draw(const FrameTime& time);
    // Places the anatomy, and handles the hands.
    Result<RoomFollowed> follow(const FrameTime& time, const std::vector<Eye>& eyes, const TwoHands& hands,
                                bool isTracked);
    Result<bool> change(const RoomState& state, Lasts lasts);
    Result<void> acquire();
    // Sets the pictures for the present positions of the eyes; false: these are not usable.
    Result<bool> aim(std::vector<Eye> eyes, const std::optional<Pose>& gaze, Shown& shown);
    Result<std::vector<XrCompositionLayerProjectionView>> drawFor(Shown& shown, double light);
    std::vector<std::vector<VisiblePart>> seenOf(const EyePictures& pictures, std::size_t firstView,
                                                 double light);
    Result<void> addDepths(const Shown& shown, std::span<const gpu::Buffer* const> depths,
                           std::span<XrCompositionLayerProjectionView> views);
    Result<void> copyForOthers();
    Result<void> workUntilNext(double begunAgoMs);
    std::optional<double> timeFor(Work work, double begunAgoMs);

    Session session_;
    Hands hands_;       // destroyed before the session
    Lent lent_;         // likewise
    QuadLayers quads_;  // likewise
    EyeMasks masks_;
    EyeCopy copy_;
    std::unique_ptr<PictureWriter> writer_ = std::make_unique<PictureWriter>();
    RoomView* view_;
    std::shared_ptr<RoomControls> controls_;
    bool wantsPicture_ = false;
    bool copiesForPicture_ = false;  // the running copy is for a picture
    XrTime mirroredAt_ = 0;
    bool holdsRate_;
    Governor governor_;
    std::uint64_t framesShown_ = 0;
    FrameTimes times_;
    bool isConfused_ = false;  // an unusable view was logged already
    double changesMs_ = 0.0;   // spent in this frame on showing another state
    std::optional<glm::dmat4> stageFromWorld_;
    std::optional<Shown> shown_;
};

}  // namespace macula::xr
