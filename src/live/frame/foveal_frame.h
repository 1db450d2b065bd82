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

    // Whether make() has succeeded. hasDisplayOf, setScene, hasTimeForFovea, hasFovea, draw, and what traces,
    // adopts or forgets a fovea require it; so does wantsFovea, unless hasRoomForFovea() is false.
    bool isThere() const { return frame_.has_value(); }
    Result<void> make();
    void drop() { frame_.reset(); }  // and frees its memory
    // The memory in use on the device has changed, so a fovea may fit again.
    void roomChanged() { hasRoom_ = true; }

    // Whether the frame has this exposure and tone map: grey faces of a clip depend on them.
    bool hasDisplayOf(const trace::Settings& settings) const;
    Result<void> setScene(const trace::Settings& settings) { return frame_->setScene(settings); }

    // Whether to trace another fovea. At rest: a small one at once, then larger ones, unless all pixels
    // together take less time than a large fovea (kRestFoveaBudgetMs).
    bool wantsFovea(const FrameInput& input) const;
    // Whether there is time for a fovea large enough to be worth the frames that it delays.
    bool hasTimeForFovea(const FrameInput& input) const;
    // Traces for a time slice, and then on until a new input comes. Returns whether a new fovea is finished.
    Result<bool> traceFovea(const FrameInput& input, const Interrupts& interrupts);
    // Makes the traced picture of all pixels the fovea, if there is room for it.
    Result<void> adopt(trace::PathTracer& tracer, const hybrid::FoveaAim& aim);
    bool hasFovea() const { return frame_->hasFovea(); }
    bool hasRoomForFovea() const { return hasRoom_; }
    void forgetFovea() { frame_->forgetFovea(); }
    // Traces no fovea until roomChanged(), because the device lacks the memory.
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
