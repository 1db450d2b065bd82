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

// What the caller wants of a session.
struct SessionOptions {
    bool showsRoom = false;  // the real room behind the anatomy, if the headset can
};

struct FrameTime {
    XrTime displayed = 0;  // the predicted time of display
    double periodMs = 0.0;
    bool shouldRender = false;
};

XrPosef toXr(const Pose& pose);
Pose fromXr(const XrPosef& pose);

// Used by one thread at a time, the one that uses the device: frames use its queue. All calls may fail with
// deviceLost when session or runtime are lost; then drop it, and begin another one.
class Session {
  public:
    enum class Phase {
        waiting,  // nobody wears the headset: listen again after a while
        running,  // frames are wanted
        ended,    // drop it
    };

    // `device` comes from openDevice. deviceNotUsable when the runtime refuses.
    static Result<Session> begin(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
                                 const SessionOptions& request = {});

    Session(Session&& other) noexcept;
    Session& operator=(Session&&) = delete;
    ~Session();

    // Reads the runtime's events, and responds to them.
    Result<Phase> listen();
    // Whether the wearer has recentred the space between the last call and that time. The runtime announces
    // it in advance.
    bool wasRecentred(XrTime time);
    // Whether the lens masks have changed since the last call; true the first time.
    bool hasNewMasks();
    // Asks the runtime to end: frames continue until listen() returns ended.
    Result<void> requestEnd();

    // Waits for the frame's time. The frame must be ended, with pictures or without.
    Result<FrameTime> beginFrame();
    // Each eye, then each inset. Empty while the headset does not know its position, or reports an unusable
    // one. `isTracked`: whether it sees where it is, and does not only estimate it.
    Result<std::vector<Eye>> eyesAt(XrTime time, bool* isTracked = nullptr) const;
    // The part of that view that no lens shows; empty if the headset has no mask.
    Result<VisibilityMask> maskOf(std::uint32_t view) const;
    // Whether the real room is visible behind the pictures, by their alpha.
    bool blendsByAlpha() const { return blend_ == XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND; }
    XrEnvironmentBlendMode blendMode() const { return blend_; }
    // `views`: in the stage, one for each eye, and one for each inset; empty: shows nothing. `quads` float
    // before them.
    Result<void> endFrame(const FrameTime& time, std::span<const XrCompositionLayerProjectionView> views,
                          std::span<const XrCompositionLayerQuad> quads = {});

    // The pose of a space in the stage; nothing while it is unknown or unusable.
    Result<std::optional<Pose>> locate(XrSpace space, XrTime time) const;

    // Frames that were begun but never submitted.
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
    std::optional<XrTime> recentredFrom_;  // from a change not yet reported by wasRecentred()
    bool hasNewMasks_ = true;
    std::uint64_t framesBegun_ = 0;
    std::uint64_t framesEnded_ = 0;
};

}  // namespace macula::xr
