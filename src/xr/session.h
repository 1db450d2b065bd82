// One use of the headset: from when it is put on until it is taken off or lost.
//
//   switch (*session.listen()) running:
//     MACULA_TRY(const FrameTime time, session.beginFrame());       // waits: the headset sets the pace
//     if (time.shouldRender) MACULA_TRY(eyes, session.eyesAt(time.displayed)), draw ...
//     session.endFrame(time, views);                                // always
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "xr/eyes.h"
#include "xr/runtime.h"
#include "xr/visibility_mask.h"

namespace macula::xr {

// What somebody wants of a session.
struct SessionOptions {
    bool showsRoom = false;  // behind the anatomy, where the headset can
};

struct FrameTime {
    XrTime displayed = 0;  // when the frame will be seen
    double periodMs = 0.0;
    bool shouldRender = false;
};

XrPosef toXr(const Pose& pose);
Pose fromXr(const XrPosef& pose);

// Used by one thread at a time, the one that uses the device: frames use its queue. Errors of all calls:
// deviceLost when the session or the runtime is lost; then drop it, and begin another one.
class Session {
  public:
    enum class Phase {
        waiting,  // it is not worn yet, or was taken off: listen again after a while
        running,  // frames are wanted
        ended,    // drop it
    };

    // `device` is that of openDevice. deviceNotUsable when the runtime refuses.
    static Result<Session> begin(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
                                 const SessionOptions& request = {});

    Session(Session&& other) noexcept;
    Session& operator=(Session&&) = delete;
    ~Session();

    // Hears what the runtime has to say, and does what it asks for.
    Result<Phase> listen();
    // Whether by that time the space is another than when somebody asked last: who wears it has recentred. It
    // is announced before it is so.
    bool wasRecentred(XrTime time);
    // Whether what lenses show has changed, likewise; true the first time.
    bool hasNewMasks();
    // Asks the runtime to end: frames go on until listen() says ended.
    Result<void> requestEnd();

    // Waits until it is time. The frame must be ended, with pictures or without.
    Result<FrameTime> beginFrame();
    // Of each eye, then of each inset. Nothing while the headset does not know where it is, or says what is
    // no place. `isTracked`: whether it sees where it is, and does not only guess.
    Result<std::vector<Eye>> eyesAt(XrTime time, bool* isTracked = nullptr) const;
    // What no lens shows of that view; none where the headset does not say.
    Result<VisibilityMask> maskOf(std::uint32_t view) const;
    // Whether the room is seen behind what is shown, by the picture's alpha.
    bool blendsByAlpha() const { return blend_ == XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND; }
    XrEnvironmentBlendMode blendMode() const { return blend_; }
    // `views`: of the stage, one for each eye, and one for each inset; none: nothing is shown. `quads` float
    // before them.
    Result<void> endFrame(const FrameTime& time, std::span<const XrCompositionLayerProjectionView> views,
                          std::span<const XrCompositionLayerQuad> quads = {});

    // Where a space is in the stage; nothing while nobody knows, likewise.
    Result<std::optional<Pose>> locate(XrSpace space, XrTime time) const;

    // Frames that were begun and never came to be submitted.
    std::uint64_t unsubmitted() const { return framesBegun_ - framesEnded_; }

    XrSession handle() const { return session_; }
    XrSpace stage() const { return stage_; }
    const Runtime& runtime() const { return *runtime_; }
    const std::shared_ptr<Runtime>& sharedRuntime() const { return runtime_; }
    const std::shared_ptr<gpu::Device>& device() const { return device_; }

  private:
    Session(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device)
        : runtime_(std::move(runtime)), device_(std::move(device)) {}
    Result<void> create();
    void chooseBlendMode(const SessionOptions& request);
    Result<void> makeStage();
    Result<void> hear(const XrEventDataBuffer& event);
    Result<void> changeTo(XrSessionState state);

    std::shared_ptr<Runtime> runtime_;
    std::shared_ptr<gpu::Device> device_;
    XrSession session_ = XR_NULL_HANDLE;
    XrSpace stage_ = XR_NULL_HANDLE;
    XrEnvironmentBlendMode blend_ = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    Phase phase_ = Phase::waiting;
    std::optional<XrTime> recentredFrom_;  // not asked for yet
    bool hasNewMasks_ = true;
    std::uint64_t framesBegun_ = 0;
    std::uint64_t framesEnded_ = 0;
};

}  // namespace macula::xr
