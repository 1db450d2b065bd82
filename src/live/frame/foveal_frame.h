// Frames of splats with a traced fovea over them, as long as the device has memory for one.
#pragma once

#include <optional>

#include "base/result.h"
#include "live/frame/frame_input.h"
#include "live/frame/interrupts.h"
#include "live/frame/render_device.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"

namespace macula::live {

// The HybridFrame of a renderer: decides how large its fovea is, and when it is traced.
//
// Used by the render thread alone.
class FovealFrame {
  public:
    explicit FovealFrame(RenderDevice& device) : device_(device) {}

    // Whether it was made. All but make, drop, roomChanged and forgetLast require that.
    bool isThere() const { return frame_.has_value(); }
    Result<void> make();
    void drop() { frame_.reset(); }  // and its memory with it
    // The memory in use on the device has changed, so a fovea may fit again.
    void roomChanged() { hasRoom_ = true; }

    // Whether the frame was set to these, on which grey faces of a clip depend.
    bool hasDisplayOf(const trace::Settings& settings) const;
    Result<void> setScene(const trace::Settings& settings) { return frame_->setScene(settings); }

    // Whether another fovea is to be traced: at rest a small one at once, and larger ones after it, where all
    // pixels take longer still.
    bool wantsFovea(const FrameInput& input) const;
    // Whether a hand leaves enough time for a fovea that is worth the frames that come later for it.
    bool hasTimeForFovea(const FrameInput& input) const;
    // Traces for a slice, and longer until a new input comes. Whether a new fovea is there.
    Result<bool> traceFovea(const FrameInput& input, const Interrupts& interrupts);
    // Makes the traced picture of all pixels the fovea, if there is room for it.
    Result<void> adopt(trace::PathTracer& tracer, const hybrid::FoveaAim& aim);
    bool hasFovea() const { return frame_->hasFovea(); }
    bool hasRoomForFovea() const { return hasRoom_; }
    void forgetFovea() { frame_->forgetFovea(); }
    // Traces none until the scene or the size changes: there is no memory for it.
    void doWithoutFovea();

    // The picture of the only eye, until the next is drawn.
    Result<const gpu::Image*> draw(const hybrid::FrameRequest& request, const hybrid::Periphery& periphery);
    // Data of the last frame, without its pictures.
    const hybrid::Frame& last() const { return last_; }
    // Whether splats were mixed into its traced picture (FrameShown::mixesModel).
    bool mixesModel() const { return mixesModel_; }
    void forgetLast();
    void forgetMix() { mixesModel_ = false; }

  private:
    double msPerSample() const;
    hybrid::FoveaAim nextFovea(const FrameInput& input) const;

    RenderDevice& device_;
    std::optional<hybrid::HybridFrame> frame_;
    bool hasRoom_ = true;
    hybrid::Frame last_;
    bool mixesModel_ = false;
};

}  // namespace macula::live
