// A picture from a side that no light need have been traced for: coverage as the guides find it, and light
// from the radiance cache of the traced views (light_in_space.h) where its rays meet matter. It costs a small
// part of what tracing does, and teaches a model how what it knows looks from many more sides than it has
// pictures of.
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

// The rays along each side of a pixel of a lit picture. With one ray, detail smaller than a pixel is there or
// not, which costs 0.15 dB with bone; large pictures have small pixels, and need fewer.
int raysAside(const glm::ivec2& sizePx);

// A lit picture on its way to the host. Begun, finished and dropped by the thread that uses the device.
class LitPicture {
  public:
    Result<void> finish() { return reading_.finish(); }  // waits
    // After that, on any thread, until it is begun again. It has no samples.
    TracedView view() const;

  private:
    friend class LightTable;

    gpu::Reading reading_;
    Camera camera_;
    glm::ivec2 sizePx_{0};
};

// A radiance cache on the device, as it was when this was made.
class LightTable {
  public:
    // After LightInSpace::finish(). Errors: outOfMemory.
    static Result<LightTable> create(const std::shared_ptr<gpu::Device>& device, const LightInSpace& light);

    // The picture has no samples. Where matter is seen that no traced view has come near, pixels are NaN: not
    // known. `tracer`, on the same device, is left with another view. Waits. Errors: usage with parallel
    // rays.
    Result<TracedView> lit(trace::PathTracer& tracer, const Camera& camera, const glm::ivec2& sizePx);
    // The same without waiting where device memory is not host memory: many pictures may be under way, and
    // take no more of the device's memory than one.
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
    std::optional<gpu::Buffer> layers_;  // of the picture begun last; likewise
    std::optional<gpu::Buffer> pixels_;
};

}  // namespace macula::hybrid
