// Keeps a traced picture, and draws it as other eyes see it: by its depths, without rubber sheets across
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
    gpu::TexelBuffer depths;      // vec2: mm from the eye, negative without a surface; uncertainty, mm
    gpu::Buffer variances;        // float: TracedLight::variances
    gpu::TexelBuffer trusts;      // float: trust in `lights` over splats (trust.h); 1 at first
};

// Valid until the next picture is reprojected.
struct ReprojectedPicture {
    const gpu::TexelBuffer* lights = nullptr;   // vec4 for each pixel: linear, premultiplied
    const gpu::TexelBuffer* weights = nullptr;  // float for each pixel: from 0, nothing known, to 1
};

// A picture of splats on the device, with depth in mm times coverage for each pixel
// (splat::Rasterizer::depths).
struct DrawnSplats {
    const splat::DevicePicture* picture = nullptr;
    const gpu::Buffer* depthSums = nullptr;  // null from a Periphery: no influence on a fovea
};

// The parameters of a reprojection from one eye to another. `seenMm` contains all that can be seen. Fails
// with usage if basis(camera) does.
Result<shared::ReprojectPush> reprojectionOf(const Camera& before, const glm::ivec2& beforeSizePx,
                                             const Camera& now, const glm::ivec2& sizePx, const Box& seenMm,
                                             double edgeFade);

// The part of the picture of `now` that may show what `before` has seen: it begins at a multiple of 8 pixels,
// and is empty (size 0) if all of that is out of sight. Both must be usable cameras.
struct PixelRegion {
    glm::ivec2 firstPx{0};
    glm::ivec2 sizePx{0};
};
PixelRegion reprojectedRegion(const Camera& before, const glm::ivec2& beforeSizePx, const Camera& now,
                              const glm::ivec2& sizePx, const Box& seenMm);

// Used by one thread at a time, the one that uses the device. No pixels pass through the host, and no call
// waits for the device.
class Reprojection {
  public:
    static Result<Reprojection> create(const std::shared_ptr<gpu::Device>& device);

    // Keeps what `tracer` has traced so far of its view, which must be `view`, without foveation. Traces its
    // guides if they are missing, which may take long. Keeps a middle part of `sizePx`, or everything if that
    // is 0; each side must be as even or odd as that of the view. Fails with outOfMemory.
    Result<CapturedPicture> capture(trace::PathTracer& tracer, const trace::View& view, const Box& seenMm,
                                    const glm::ivec2& sizePx = glm::ivec2(0));

    // `edgeFade`: share of the sides of `before` over which its weight falls to 0. `splats`: drawn for `now`
    // in `sizePx`; they show roughly where surfaces are. Fails with outOfMemory, and usage as reprojectionOf
    // does.
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
    std::optional<gpu::TexelBuffer> hardWeights_;  // vec2: weight before feather.glsl softens borders; trust
    std::optional<gpu::TexelBuffer> weights_;
};

}  // namespace macula::hybrid
