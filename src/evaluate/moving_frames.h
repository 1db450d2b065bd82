// Frames of an eye that has gone on since their fovea was traced, and what both cost.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/progress.h"
#include "base/result.h"
#include "evaluate/frame_makers.h"
#include "evaluate/frame_recipes.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/splat/draw/model_painter.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::evaluate {

class MovingFrames {
  public:
    // Of the scene of `beside`. `splats` must be valid, and outlive this unchanged; so must `progress`.
    static Result<MovingFrames> create(std::shared_ptr<gpu::Device> device, const trace::PathTracer& beside,
                                       const splat::Splats& splats, const glm::ivec2& sizePx,
                                       const Progress& progress);

    // Traces the fovea of the frames to come, in the middle of what `eye` sees, as fine as the frame there;
    // nothing that was traced before helps. The milliseconds that it took, until the device had finished.
    // `cancelled`.
    Result<double> traceFovea(const Camera& eye, const TracedFovea& fovea);

    // The second of two equal frames for `now`, so that kernels and buffers are there; MadeFrame::ms is of
    // splats, reprojection and composition. The fovea is warped to `now`, or left where it was on the screen;
    // splats alone where none was traced. An eye that is farther than HybridFrame::kMostTurnDeg from where it
    // was traced is not shown a warped one.
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

}  // namespace macula::evaluate
