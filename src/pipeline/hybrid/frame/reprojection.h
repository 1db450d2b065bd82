// A traced picture that is kept, and drawn as other eyes see it: by its depths, without rubber sheets across
// edges (shaders/lib/reproject.glsl).
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/frames.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/splat/draw/device_picture.h"
#include "pipeline/trace/path_tracer.h"
#include "shared/reproject_params.h"

namespace macula::hybrid {

// On the device.
struct CapturedPicture {
    Camera camera;
    glm::ivec2 sizePx{0};
    splat::DevicePicture lights;  // linear, premultiplied: means of samples
    gpu::TexelBuffer depths;      // vec2: mm from the eye, negative where there is none; uncertainty, mm
    gpu::Buffer variances;        // float: TracedLight::variances
    gpu::TexelBuffer trusts;      // float: trust in `lights` over splats (trust.h); 1 at first
};

// Valid until the next picture is reprojected.
struct ReprojectedPicture {
    const gpu::TexelBuffer* lights = nullptr;   // vec4 for each pixel: linear, premultiplied
    const gpu::TexelBuffer* weights = nullptr;  // float for each pixel: 0, nothing is known here, to 1
};

// A picture of splats on the device, and for each pixel their depth in mm times their coverage
// (splat::Rasterizer::depths).
struct DrawnSplats {
    const splat::DevicePicture* picture = nullptr;
    const gpu::Buffer* depthSums =
        nullptr;  // may be null in a Periphery: it tells no depths, and knows nothing
};

// From one eye to another. `seenMm` is around all that can be seen. Fails with usage where basis(camera)
// does.
Result<shared::ReprojectPush> reprojectionOf(const Camera& before, const glm::ivec2& beforeSizePx,
                                             const Camera& now, const glm::ivec2& sizePx, const Box& seenMm,
                                             double edgeFade);

// The part of the picture that `now` sees in which what `before` has seen can lie: whole groups of 8 pixels,
// nothing (size 0) where it is out of sight. Both are usable cameras.
struct PixelRegion {
    glm::ivec2 firstPx{0};
    glm::ivec2 sizePx{0};
};
PixelRegion reprojectedRegion(const Camera& before, const glm::ivec2& beforeSizePx, const Camera& now,
                              const glm::ivec2& sizePx, const Box& seenMm);

// Used by one thread at a time, the one that uses the device. Nothing goes through the host, and nothing is
// waited for.
class Reprojection {
  public:
    static Result<Reprojection> create(const std::shared_ptr<gpu::Device>& device);

    // What `tracer` has traced so far, of its view, which is `view`, without foveation. Its guides are made
    // where they are not there yet, which may take long. outOfMemory.
    // `sizePx`: of what is kept of its middle, at most all and each side as even or odd as that of the view;
    // 0: all.
    Result<CapturedPicture> capture(trace::PathTracer& tracer, const trace::View& view, const Box& seenMm,
                                    const glm::ivec2& sizePx = glm::ivec2(0));

    // `edgeFade`: share of the sides of `before` over which its weight falls to nothing. `splats`: of `now`,
    // of that size; they tell about where surfaces are. outOfMemory; usage as reprojectionOf.
    Result<ReprojectedPicture> reproject(const CapturedPicture& before, const Camera& now,
                                         const glm::ivec2& sizePx, const Box& seenMm, double edgeFade,
                                         const std::optional<DrawnSplats>& splats = {});

  private:
    struct Kernels {
        gpu::Kernel capture;
        gpu::Kernel reproject;
        gpu::Kernel reprojectBySplats;
        gpu::Kernel feather;
    };
    Reprojection(std::shared_ptr<gpu::Device> device, Kernels kernels)
        : device_(std::move(device)), kernels_(std::move(kernels)) {}

    std::shared_ptr<gpu::Device> device_;
    Kernels kernels_;
    std::optional<gpu::TexelBuffer> lights_;       // of the last picture; may have room for more
    std::optional<gpu::TexelBuffer> hardWeights_;  // vec2: before their borders are softened; trust
    std::optional<gpu::TexelBuffer> weights_;
};

}  // namespace macula::hybrid
