// A study as both eyes see it: the same facade that the window has (pipeline/hybrid/frame). Knows no OpenXR.
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

// How eyes are shown it.
struct RoomLook {
    double light = 1.0;                             // how much of it is seen, 0 to 1
    bool keepsCoverage = false;                     // the room is seen behind it
    std::optional<hybrid::DepthRange> depths = {};  // in which depths are told; nothing: none are
};

struct RoomPictures {
    hybrid::Frame frame;
    // Of each of its pictures (EyeDepths::make); none while they are not known.
    std::vector<const gpu::Buffer*> depths;
};

// What is done for later frames.
struct WorkRequest {
    double budgetMs = 0.0;
    glm::dvec2 gaze{0.0};   // in the picture of the centre eye
    double fineness = 1.0;  // of pixels where they look, over that of the pictures
    // Of each pixel in balanced quality, while neither head nor eyes move.
    std::uint32_t mostSamples = mostSamplesOf(RoomQuality::balanced);
};

struct RoomOptions {
    std::optional<hybrid::LiveModelOptions> model = {};  // nothing: what suits the device
    bool learns = true;                                  // false: no model is made; all is traced
};

// Used by one thread at a time, the one that uses the device.
class RoomView {
  public:
    // usage for a look that is not path-traced, and for light that hangs on the camera: there are two eyes,
    // and both see the same light. inputNotUsable when nothing can be seen. What was learnt goes to the
    // shelf, which may outlive the device.
    static Result<RoomView> create(const std::shared_ptr<gpu::Device>& device, RoomScene scene,
                                   std::shared_ptr<hybrid::ModelShelf> shelf,
                                   const RoomOptions& options = {});

    const Box& seenMm() const { return seenMm_; }
    const RoomScene& scene() const { return scene_; }

    // What of the scene a person chooses.
    RoomState state() const;

    // Of splats: what is nearer is not drawn. Of what is traced, all is seen, however near.
    void setNear(double nearMm) { nearMm_ = nearMm; }

    // Waits for nothing. Pictures are valid until the next call: of both eyes, then of both insets.
    Result<RoomPictures> draw(const EyePictures& eyes, const EyePictures* insets = nullptr,
                              const RoomLook& look = {});
    // Whose turn it is: fovea, where the eyes look, and what the model learns take turns.
    Work nextWork() const;
    bool wants(Work work) const {
        return work == Work::fovea || (options_.learns && !isForALook_ && model_.hasWork());
    }
    // Nothing is learnt or traced yet of what is shown: it is dark.
    bool isDark() const { return !drawsModel() && !hybrid_.hasFovea(); }
    // About as long as is wanted, at least a dispatch of some 12 ms or a step of learning.
    Result<void> work(Work work, const EyePictures& eyes, const WorkRequest& request);

    // Shows another state. What is for a look is traced alone, and nothing is learnt of it; `scene` stays as
    // it was. False, and all is as it was, when nothing would be left, or it is no valid state.
    Result<bool> show(const RoomState& state, Lasts lasts = Lasts::forGood);
    // Removes what is not kept too. False, and nothing happens, when nothing would be left, or the clip has
    // all the planes that it may have.
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
    RoomState shown_;  // that of the scene, or what is shown for a look
    bool isForALook_ = false;
    double nearMm_ = 10.0;
    live::SceneIds names_;
    trace::PathTracer tracer_;
    hybrid::HybridFrame hybrid_;
    hybrid::LiveModel model_;
    Box seenMm_;
    std::vector<splat::DevicePicture> nothing_;  // instead of splats while there are none, of each size
    std::optional<hybrid::EyeDepths> depths_;
    struct Aimed {
        hybrid::FoveaAim aim;
        glm::dvec2 gaze{0.0};
        bool isOverModel = false;
    };
    std::optional<Aimed> aimed_;  // the last one
    bool wasTurnOfModel_ = false;
    bool hasSaidNoRoom_ = false;  // once, not in each frame
};

}  // namespace macula::xr
