// How noisy each pixel of a film is: shaders/lib/variance.glsl on the device.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/film.h"

namespace macula::trace {

// Used by one thread at a time, the one that uses the device.
class VarianceMap {
  public:
    explicit VarianceMap(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {}

    // The variance of the mean luminance (Rec. 709) of each pixel's samples so far: float for each pixel, row
    // 0 on top; the buffer may be larger. The device computes it after the work submitted before. Valid until
    // the next call. Fails with outOfMemory.
    Result<const gpu::Buffer*> of(const Film& film);

  private:
    std::shared_ptr<gpu::Device> device_;
    std::optional<gpu::Buffer> variances_;
};

}  // namespace macula::trace
