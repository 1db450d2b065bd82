// How far traced light is to be trusted over splats of the same view, pixel by pixel: runs
// shaders/lib/trust.glsl on the device. Few samples are worse than a good model, and better than a bad one.
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

// Used by one thread at a time, the one that uses the device. No pixels pass through the host, and no call
// waits for the device.
class Trust {
  public:
    static Result<Trust> create(const std::shared_ptr<gpu::Device>& device);

    // Writes a float for each pixel into `trusts`, row 0 on top: from 0, where the splats are better, to 1.
    // `traced` is noisyLight(). All have the size of `splats`, whose light `splatGain` multiplies. Fails with
    // outOfMemory.
    Result<void> weigh(const trace::TracedLight& traced, const splat::DevicePicture& splats, float splatGain,
                       const gpu::TexelBuffer& trusts);

  private:
    Trust(std::shared_ptr<gpu::Device> device, gpu::Kernel rows, gpu::Kernel trust)
        : device_(std::move(device)), rows_(std::move(rows)), trust_(std::move(trust)) {}

    std::shared_ptr<gpu::Device> device_;
    gpu::Kernel rows_;
    gpu::Kernel trust_;
    std::optional<gpu::Buffer> terms_;  // vec2 for each pixel; may have room for more
};

}  // namespace macula::hybrid
