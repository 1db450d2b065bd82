// A study as both eyes see it, with the same facade as in the window (pipeline/hybrid/frame). Knows no
// OpenXR.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "live/frame/scene_ids.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/frame/eye_depths.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/hybrid/model/live_model.h"
#include "pipeline/hybrid/model/model_shelf.h"
#include "pipeline/trace/path_tracer.h"
#include "scene/drawing/drawing.h"
#include "xr/eyes.h"
#include "xr/governor.h"
#include "xr/room_controls.h"
#include "xr/room_state.h"

namespace macula::xr {

struct RoomScene {
    std::shared_ptr<const Volume> volume;  // in 16 bits
    scene::Drawing drawing;                // complete
    RoomQuality quality = RoomQuality::balanced;
};

// How the room appears to the eyes.
struct RoomLook {
    double light = 1.0;                             // brightness, 0 to 1
    bool keepsCoverage = false;                     // the real room is visible behind it
    std::optional<hybrid::DepthRange> depths = {};  // range in which to encode depths; nothing: no depths
};

struct RoomPictures {
    hybrid::Frame frame;
    // The depths of each picture (EyeDepths::make); empty while there are none.
    std::vector<const gpu::Buffer*> depths;
};

// Work for later frames.
struct WorkRequest {
    double budgetMs = 0.0;
    glm::dvec2 gaze{0.0};   // in the centre eye's picture
    double fineness = 1.0;  // pixel density at the gaze, relative to the pictures
    // Per pixel in balanced quality, while neither head nor eyes move.
    std::uint32_t mostSamples = mostSamplesOf(RoomQuality::balanced);
};

struct RoomOptions {
    std::optional<hybrid::LiveModelOptions> model = {};  // nothing: suitable ones for the device
    bool learns = true;                                  // false: makes no model, and traces everything
};

// Used by one thread at a time, the one that uses the device.
class RoomView {
  public:
    // usage for a look that is not path-traced, and for lights attached to the camera: both eyes must see the
    // same light. inputNotUsable if nothing is visible. The learned model goes to the shelf, which may
    // outlive the device.
    static Result<RoomView> create(const std::shared_ptr<gpu::Device>& device, RoomScene scene,
                                   std::shared_ptr<hybrid::ModelShelf> shelf,
                                   const RoomOptions& options = {});

    const Box& seenMm() const { return seenMm_; }
    const RoomScene& scene() const { return scene_; }

    // The part of the scene that a person can choose.
    RoomState state() const;

    // Splats nearer than this are not drawn; traced pictures have no near limit.
    void setNear(double nearMm) { nearMm_ = nearMm; }

    // Does not wait for the device. Pictures are valid until the next call: both eyes, then both insets.
    Result<RoomPictures> draw(const EyePictures& eyes, const EyePictures* insets = nullptr,
                              const RoomLook& look = {});
    // Whose turn it is: tracing the fovea and training the model alternate.
    Work nextWork() const;
    bool wants(Work work) const {
        return work == Work::fovea || (options_.learns && !isForALook_ && model_.hasWork());
    }
    // Nothing of the scene is learned or traced yet, so the pictures are dark.
    bool isDark() const { return !drawsModel() && !hybrid_.hasFovea(); }
    // Works for about the budget, but at least for one dispatch of about 12 ms, or one training step.
    Result<void> work(Work work, const EyePictures& eyes, const WorkRequest& request);

    // Shows another state. A preview (Lasts::forALook) is only traced, and nothing is learned from it;
    // `scene` stays as it was. False, and nothing changes, if nothing would be visible, or if the state is
    // not valid.
    Result<bool> show(const RoomState& state, Lasts lasts = Lasts::forGood);
    // Cuts the scene to `kept` as well. False, and nothing happens, if nothing would be left, or if the clip
    // has the most planes already.
    Result<bool> cut(const HalfSpace& kept);

    hybrid::HybridFrame& frame() { return hybrid_; }
    hybrid::LiveModel& model() { return model_; }
    hybrid::Periphery periphery();

  private:
    RoomView(std::shared_ptr<gpu::Device> device, RoomScene scene, const RoomOptions& options,
             trace::PathTracer tracer, hybrid::HybridFrame hybrid, hybrid::LiveModel model)
        : device_(std::move(device)),
          scene_(std::move(scene)),
          options_(options),
          tracer_(std::move(tracer)),
          hybrid_(std::move(hybrid)),
          model_(std::move(model)) {}
    Result<void> applyScene();
    Result<void> apply(const RoomState& state);
    bool drawsModel() const { return !isForALook_ && model_.canBeDrawn(); }
    Result<hybrid::DrawnSplats> drawSplats(const Camera& eye, const glm::ivec2& sizePx);
    Result<void> traceFovea(const EyePictures& eyes, const WorkRequest& request,
                            const std::function<bool()>& keepGoing);
    hybrid::FoveaAim newFovea(const EyePictures& eyes, const WorkRequest& request) const;

    std::shared_ptr<gpu::Device> device_;
    RoomScene scene_;
    RoomOptions options_;
    RoomState shown_;  // the scene's state, or a preview
    bool isForALook_ = false;
    double nearMm_ = 10.0;
    live::SceneIds names_;
    trace::PathTracer tracer_;
    hybrid::HybridFrame hybrid_;
    hybrid::LiveModel model_;
    Box seenMm_;
    std::vector<splat::DevicePicture> nothing_;  // empty ones, while there are no splats; one for each size
    std::optional<hybrid::EyeDepths> depths_;
    struct Aimed {
        hybrid::FoveaAim aim;
        glm::dvec2 gaze{0.0};
        bool isOverModel = false;
    };
    std::optional<Aimed> aimed_;  // the last aim
    bool wasTurnOfModel_ = false;
    bool hasSaidNoRoom_ = false;  // logs it once, not in each frame
};

}  // namespace macula::xr
