// The depth of each pixel that an eye is shown, as in a depth buffer: for those who draw other things into
// the picture, or shift it to where the eye is by the time of display.
#pragma once

#include <deque>
#include <glm/glm.hpp>
#include <memory>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/hybrid/frame/reprojection.h"

namespace macula::hybrid {

// The near and the far plane, in any unit. A depth is 0 at the near one and 1 at the far one, and linear in
// the reciprocal of the distance along the middle of the view.
struct DepthRange {
    float nearest = 0.01f;
    float farthest = 100.0f;
    float unitsPerMm = 1e-3f;
};

// Used by one thread at a time, the one that uses the device. Waits for nothing.
class EyeDepths {
  public:
    static Result<EyeDepths> create(const std::shared_ptr<gpu::Device>& device);

    // The depth of each pixel of `splats` that is more than half covered, else 1: float32, row 0 on top; the
    // buffer may be longer. Valid until the next call for that eye. `splats` must have depth sums. Fails with
    // outOfMemory.
    Result<const gpu::Buffer*> make(std::size_t eye, const DrawnSplats& splats, const DepthRange& range);

  private:
    EyeDepths(std::shared_ptr<gpu::Device> device, gpu::Kernel kernel)
        : device_(std::move(device)), kernel_(std::move(kernel)) {}

    std::shared_ptr<gpu::Device> device_;
    gpu::Kernel kernel_;
    std::deque<gpu::Buffer> depths_;  // by eye; a deque, so that returned pointers stay valid
};

}  // namespace macula::hybrid
