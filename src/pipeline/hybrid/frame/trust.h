// How far traced light is to be trusted over splats of the same view, pixel by pixel: what
// shaders/lib/trust.glsl says, on the device. Few samples are worse than a good model, and better than a bad
// one.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/splat/draw/device_picture.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// Used by one thread at a time, the one that uses the device. Nothing goes through the host, and nothing is
// waited for.
class Trust {
  public:
    static Result<Trust> create(const std::shared_ptr<gpu::Device>& device);

    // `traced` is noisyLight(). Into `trusts`, float for each pixel, row 0 on top: 0, the splats are better
    // there, to 1. All are of the size of `splats`, whose light `splatGain` multiplies. outOfMemory.
    Result<void> weigh(const trace::TracedLight& traced, const splat::DevicePicture& splats, float splatGain,
                       const gpu::TexelBuffer& trusts);

  private:
    Trust(std::shared_ptr<gpu::Device> device, gpu::Kernel rows, gpu::Kernel trust)
        : device_(std::move(device)), rows_(std::move(rows)), trust_(std::move(trust)) {}

    std::shared_ptr<gpu::Device> device_;
    gpu::Kernel rows_;
    gpu::Kernel trust_;
    std::optional<gpu::Buffer> terms_;  // vec2 for each pixel; there may be room for more
};

}  // namespace macula::hybrid
