// A picture from a side for which no light was traced: its rays are marched for coverage, and the radiance
// cache of the traced views (light_in_space.h) lights the matter that they meet. It costs a fraction of a
// traced picture, and teaches a model how a scene looks from many more sides.
#pragma once

#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/result.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/reading.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/hybrid/light/light_in_space.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/trace/path_tracer.h"
#include "shared/light_params.h"

namespace macula::hybrid {

// The rays along each side of a pixel of a lit picture, 2 or 1. One ray hits or misses detail smaller than a
// pixel, which costs 0.15 dB with bone; large pictures have small pixels, and need fewer.
int raysAside(const glm::ivec2& sizePx);

// A lit picture on its way to the host. Only the thread that uses the device begins, finishes and drops it.
class LitPicture {
  public:
    Result<void> finish() { return reading_.finish(); }  // waits for the device
    // Call after finish(), on any thread, until the next begin(). The view has no samples.
    TracedView view() const;

  private:
    friend class LightTable;

    gpu::Reading reading_;
    Camera camera_;
    glm::ivec2 sizePx_{0};
};

// A copy of a radiance cache on the device.
class LightTable {
  public:
    // Call after LightInSpace::finish(). Fails with outOfMemory.
    static Result<LightTable> create(const std::shared_ptr<gpu::Device>& device, const LightInSpace& light);

    // The picture has no samples. Pixels that show mostly matter which no traced view has met are NaN:
    // unknown. `tracer`, on the same device, is left with another view. Waits for the device. Fails with
    // usage for a parallel camera.
    Result<TracedView> lit(trace::PathTracer& tracer, const Camera& camera, const glm::ivec2& sizePx);
    // The same, without waiting where device memory is separate from host memory: many pictures may be under
    // way, with the device memory of one.
    Result<void> begin(trace::PathTracer& tracer, const Camera& camera, const glm::ivec2& sizePx,
                       LitPicture& picture);

  private:
    LightTable(gpu::Kernel kernel, gpu::Buffer slots, gpu::TexelBuffer cells, double cellMm)
        : kernel_(std::move(kernel)), slots_(std::move(slots)), cells_(std::move(cells)), cellMm_(cellMm) {}

    shared::LitPush pushFor(const CameraBasis& eye, const Camera& camera, const glm::ivec2& sizePx) const;

    gpu::Kernel kernel_;
    gpu::Buffer slots_;
    gpu::TexelBuffer cells_;
    double cellMm_;
    std::optional<gpu::Buffer> layers_;  // of the picture begun last, as is `pixels_`
    std::optional<gpu::Buffer> pixels_;
};

}  // namespace macula::hybrid
