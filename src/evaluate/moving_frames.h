// Frames whose eye has moved since their fovea was traced, and the time for fovea and frame.
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

}  // namespace macula::evaluate
