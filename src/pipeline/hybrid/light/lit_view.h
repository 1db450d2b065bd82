// A picture from a side that no light need have been traced for: coverage as the guides find it, and light
// from the radiance cache of the traced views (light_in_space.h) where its rays meet matter. It costs a small
// part of what tracing does, and teaches a model how what it knows looks from many more sides than it has
// pictures of.
#pragma once

#include <memory>

#include "base/result.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/hybrid/light/light_in_space.h"
#include "pipeline/hybrid/views/traced_view.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// The rays along each side of a pixel of a lit picture. With one ray, detail smaller than a pixel is there or
// not, which costs 0.15 dB with bone; large pictures have small pixels, and need fewer.
int raysAside(const glm::ivec2& sizePx);

// A radiance cache on the device, as it was when this was made.
class LightTable {
  public:
    // After LightInSpace::finish(). Errors: outOfMemory.
    static Result<LightTable> create(const std::shared_ptr<gpu::Device>& device, const LightInSpace& light);

    // The picture has no samples. Where matter is seen that no traced view has come near, pixels are NaN: not
    // known. `tracer`, on the same device, is left with another view. Waits. Errors: usage with parallel
    // rays.
    Result<TracedView> lit(trace::PathTracer& tracer, const Camera& camera, const glm::ivec2& sizePx) const;

  private:
    LightTable(gpu::Kernel kernel, gpu::Buffer slots, gpu::TexelBuffer cells, double cellMm)
        : kernel_(std::move(kernel)), slots_(std::move(slots)), cells_(std::move(cells)), cellMm_(cellMm) {}

    gpu::Kernel kernel_;
    gpu::Buffer slots_;
    gpu::TexelBuffer cells_;
    double cellMm_;
};

}  // namespace macula::hybrid
