// Makes pictures out of inputs, in steps short enough to stay responsive.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "pipeline/gpu/device.h"
#include "pipeline/gpu/instance.h"
#include "pipeline/gpu/recovery.h"
#include "pipeline/trace/path_tracer.h"
#include "viewer/frame_input.h"
#include "viewer/motion_scale.h"
#include "viewer/presenter.h"
#include "viewer/render_events.h"

namespace macula::viewer {

// Asked between dispatches. Both must be cheap.
struct Interrupts {
    std::function<bool()> newInput;
    std::function<bool()> stopping;
};

// Owns the device and all that is on it. A device that is lost is replaced, and the picture made anew from
// the input; who listens is told, and when it is lost again and again it is left at that.
//
// A picture has up to three stages: while something moves, a smaller picture of one denoised sample per pixel
// that always gets finished, or the view would never follow a steady hand; then all pixels, given up at once
// when a new input comes; then rest, when all samples are there. The smaller picture stays on screen until
// the full one is better.
//
// Used by one thread, the render thread.
class FrameRenderer {
  public:
    FrameRenderer(gpu::Instance instance, std::string preferredDevice, RenderListener listener);
    ~FrameRenderer();

    void accept(FrameInput input);

    // Whether step() has anything to do before the next input.
    bool hasWork() const;
    // At most one pass over the picture. Throws nothing.
    void step(const Interrupts& interrupts);
    // For what went wrong outside of step(): reports it, and rests until something changes. Throws nothing.
    void fail(ErrorCode code, const char* message, const char* hint);

    // Afterwards nothing refers to the surface of the last input.
    void releaseSurface();

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::int64_t kNoneRefused = std::numeric_limits<std::int64_t>::max();

    Result<void> tryStep(const Interrupts& interrupts);
    Result<void> ensureDevice();
    Result<void> ensurePresenter();
    Result<void> clearWindow();
    Result<bool> applyScene(const Interrupts& interrupts);  // whether all of it is there
    Result<void> applySettings(const trace::Settings& settings);
    Result<void> startMoving();
    Result<void> startConverging();
    Result<void> stepMoving(const Interrupts& interrupts);
    Result<void> stepConverging(const Interrupts& interrupts);
    bool hasNoise() const;
    bool mayDenoise() const;  // the picture of view_
    std::uint64_t sampleLimit() const;
    Result<const gpu::Image*> develop();
    Result<void> show(const gpu::Image& picture);
    Result<void> showPicture();
    void handle(Error error);
    void dropDevice();
    double framesPerSecond() const;

    gpu::Instance instance_;
    std::string preferredDevice_;
    RenderListener listener_;

    std::shared_ptr<gpu::Device> device_;
    std::optional<Presenter> presenter_;
    std::optional<trace::PathTracer> tracer_;

    FrameInput input_;
    // What the device has by now; compared with the input to find what to bring there.
    struct Applied {
        std::shared_ptr<const Volume> volume;
        std::shared_ptr<const TransferFunction> transferFunction;
        std::shared_ptr<const trace::LightRig> lights;
        std::optional<std::shared_ptr<const Clip>> clip;  // none: nobody knows which
        std::optional<trace::Settings> settings;
        VkExtent2D window{};
        std::uint64_t exposures = 0;
    } applied_;

    Stage stage_ = Stage::converged;
    bool restart_ = false;    // the picture must begin anew
    bool redisplay_ = false;  // the picture is right, but not what is on screen
    bool clear_ = false;      // what is on screen belongs to another study
    bool halted_ = false;     // after a failure, until something changes
    bool givenUp_ = false;    // halted, as the device was lost too often: another size changes nothing
    int scale_ = 1;
    trace::View view_;
    std::optional<MotionScale> motionScale_;
    int warmWidth_ = 0;  // of the picture in motion before
    // A picture of so many was too large to denoise for the room there was.
    std::int64_t pixelsRefused_ = kNoneRefused;
    double filterNsPerPixel_ = 0.0;  // what that took lately, guides included
    bool stillIsDenoised_ = false;
    std::uint64_t showFrom_ = 0;  // samples: the full picture is not shown with fewer
    Clock::time_point movingSince_{};
    std::uint64_t movingSamples_ = 0;
    std::uint32_t motionFrame_ = 0;
    std::deque<Clock::time_point> shown_;
    gpu::LossCount losses_;
    std::optional<FrameShown> unreported_;  // of the picture that the presenter keeps, while nobody sees it
};

}  // namespace macula::viewer
