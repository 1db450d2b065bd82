// Makes frames to compare. A frame reuses nothing from earlier frames. It is made twice, so that kernels and
// buffers exist, and the second time is measured, from the first command until the device has finished,
// without the readback.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "base/camera.h"
#include "base/progress.h"
#include "base/result.h"
#include "evaluate/frame_recipes.h"
#include "image/image.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/splat/draw/model_painter.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::evaluate {

// The time of a frame: a fixed part (guides, denoising, tone map), and the time of one sample of all pixels.
struct TracingCost {
    double fixedMs = 0.0;
    double perSampleMs = 0.0;
};

struct TracingBudget {
    glm::ivec2 sizePx{0};
    std::uint32_t samplesPerPixel = 1;

    bool operator==(const TracingBudget&) const = default;
};

// Path tracing alone in a given time. Finds the most samples of a frame of `sizePx` that fit into `budgetMs`.
// If not even one does, lowers the resolution until one does, at most to kLeastSidePx. `cost` is for the full
// size.
inline constexpr int kLeastSidePx = 8;
TracingBudget affordable(const TracingCost& cost, double budgetMs, const glm::ivec2& sizePx);

// The length of the traced sides over that of the full ones.
double resolutionShareOf(const TracingBudget& budget, const glm::ivec2& sizePx);

// The cost for the full size, estimated from the times of a frame of budget.sizePx.
TracingCost costOfWhole(double traceMs, double otherMs, const TracingBudget& budget,
                        const glm::ivec2& sizePx);

struct MadeFrame {
    image::Image shown;
    std::vector<float> foveaWeights;  // by pixel; empty without a fovea
    double ms = 0.0;
    std::uint32_t samplesPerPixel = 0;             // of the traced part; 0: nothing was traced
    double resolutionShare = 1.0;                  // resolutionShareOf
    std::optional<hybrid::FoveaTimes> foveaTimes;  // parts of `ms`, if the frame has a fovea
};

// Frames of path tracing alone, denoised. All functions fail with `cancelled` if `progress` is cancelled.
class TracedFrames {
  public:
    static Result<TracedFrames> create(std::shared_ptr<gpu::Device> device, const trace::PathTracer& beside,
                                       int bounces, const Progress& progress);

    struct Costed {
        MadeFrame frame;
        TracingCost cost;
    };
    Result<Costed> make(const Camera& camera, const glm::ivec2& sizePx, std::uint32_t samplesPerPixel);

    // Makes the best frame that fits into `budgetMs`, scaled up if its resolution is lower. `cost` is a first
    // guess, which trials improve.
    Result<MadeFrame> makeIn(double budgetMs, const TracingCost& cost, const Camera& camera,
                             const glm::ivec2& sizePx);

  private:
    struct Traced {
        image::Image shown;
        double traceMs = 0.0;
        double otherMs = 0.0;  // guides, denoising, tone map
    };
    TracedFrames(std::shared_ptr<gpu::Device> device, trace::PathTracer tracer, int bounces,
                 const Progress& progress)
        : device_(std::move(device)), tracer_(std::move(tracer)), bounces_(bounces), progress_(&progress) {}
    Result<Traced> trace(const Camera& camera, const TracingBudget& budget);
    Result<Traced> traceTwice(const Camera& camera, const TracingBudget& budget);

    std::shared_ptr<gpu::Device> device_;
    trace::PathTracer tracer_;
    int bounces_;
    std::uint32_t count_ = 0;  // of frames: the seed of each
    const Progress* progress_;
};

// Frames of splats alone, and with a fovea traced for exactly this eye.
class SplatFrames {
  public:
    // `splats` must be valid, and outlive this object unchanged.
    static Result<SplatFrames> create(std::shared_ptr<gpu::Device> device, const trace::PathTracer& beside,
                                      int bounces, const splat::Splats& splats, const Progress& progress);

    Result<MadeFrame> bare(const Camera& camera, const glm::ivec2& sizePx);
    // The fovea has trace::kFovealFieldDeg in the middle, at the resolution of the frame.
    Result<MadeFrame> withFovea(const Camera& camera, const glm::ivec2& sizePx,
                                std::uint32_t samplesPerPixel);

  private:
    SplatFrames(std::shared_ptr<gpu::Device> device, hybrid::HybridFrame frame, splat::ModelPainter painter,
                const splat::Splats& splats, int bounces, const Progress& progress)
        : device_(std::move(device)),
          frame_(std::move(frame)),
          painter_(std::move(painter)),
          splats_(&splats),
          bounces_(bounces),
          progress_(&progress) {}
    // With 0 samples: without a fovea.
    Result<MadeFrame> make(const Camera& camera, const glm::ivec2& sizePx, std::uint32_t samplesPerPixel);

    std::shared_ptr<gpu::Device> device_;
    hybrid::HybridFrame frame_;
    splat::ModelPainter painter_;
    const splat::Splats* splats_;
    int bounces_;
    const Progress* progress_;
};

// Frames whose eye has moved since their fovea was traced, and the time for fovea and frame.
class MovingFrames {
  public:
    // For the scene of `beside`. `splats` must be valid, and outlive this object unchanged, as must
    // `progress`.
    static Result<MovingFrames> create(std::shared_ptr<gpu::Device> device, const trace::PathTracer& beside,
                                       const splat::Splats& splats, const glm::ivec2& sizePx,
                                       const Progress& progress);

    // Traces the fovea for later frames, in the middle of what `eye` sees, at the frame's resolution, without
    // reusing earlier samples. Returns the milliseconds until the device has finished. Fails with
    // `cancelled`.
    Result<double> traceFovea(const Camera& eye, const TracedFovea& fovea);

    // Draws two equal frames for `now`, and returns the second, so that kernels and buffers exist;
    // MadeFrame::ms covers splats, reprojection and composition. The fovea is reprojected to `now`, or left
    // in place on the screen; without a traced one, splats stand alone. An eye that has turned by more than
    // HybridFrame::kMostTurnDeg is not shown a reprojected one.
    Result<MadeFrame> draw(const Camera& now, bool isWarped);

  private:
    MovingFrames(std::shared_ptr<gpu::Device> device, hybrid::HybridFrame frame, splat::ModelPainter painter,
                 const splat::Splats& splats, const glm::ivec2& sizePx, const Progress& progress)
        : device_(std::move(device)),
          frame_(std::move(frame)),
          painter_(std::move(painter)),
          splats_(&splats),
          sizePx_(sizePx),
          progress_(&progress) {}

    struct Traced {
        Camera eye;
        std::uint32_t samplesPerPixel = 0;
    };

    std::shared_ptr<gpu::Device> device_;
    hybrid::HybridFrame frame_;
    splat::ModelPainter painter_;
    const splat::Splats* splats_;
    glm::ivec2 sizePx_;
    const Progress* progress_;
    std::optional<Traced> fovea_;
};

// Draws the splats of a model around a fovea, as each eye sees them, except for the eye `shownTo`, which gets
// the picture of `now`. If these two differ, the result has no depths, because those of `now` would be wrong
// for `shownTo`. `painter`, whose model has the origin `originMm`, must outlive the result.
hybrid::Periphery peripheryFor(splat::ModelPainter& painter, const glm::dvec3& originMm,
                               const Camera& shownTo, const Camera& now);

// Traces the fovea that the frame was aimed at (HybridFrame::aim). Fails with `cancelled`.
Result<void> traceFovea(hybrid::HybridFrame& frame, const Progress& progress);

}  // namespace macula::evaluate
