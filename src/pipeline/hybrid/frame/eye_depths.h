// How far away is what each eye is shown, as a depth buffer has it: for who lays other things beside the
// picture, or shifts it to where the eye is by then.
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

// Between its planes, in whatever unit: a depth is 0 at the near one and 1 at the far one, and changes as 1
// over the distance along the middle of the view.
struct DepthRange {
    float nearest = 0.01f;
    float farthest = 100.0f;
    float unitsPerMm = 1e-3f;
};

// Used by one thread at a time, the one that uses the device. Waits for nothing.
class EyeDepths {
  public:
    static Result<EyeDepths> create(const std::shared_ptr<gpu::Device>& device);

    // The depth of each pixel of `splats` that is more than half covered, else 1: float32, row 0 on top,
    // perhaps more behind. Valid until the next one of that eye. `splats` has depth sums.
    // outOfMemory.
    Result<const gpu::Buffer*> make(std::size_t eye, const DrawnSplats& splats, const DepthRange& range);

  private:
    EyeDepths(std::shared_ptr<gpu::Device> device, gpu::Kernel kernel)
        : device_(std::move(device)), kernel_(std::move(kernel)) {}

    std::shared_ptr<gpu::Device> device_;
    gpu::Kernel kernel_;
    std::deque<gpu::Buffer> depths_;  // by eye; what was returned stays where it is when another eye comes
};

}  // namespace macula::hybrid
