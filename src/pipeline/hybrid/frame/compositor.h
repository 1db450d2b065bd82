// Composes the picture that a person sees from splats and traced light.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/hybrid/frame/reprojection.h"
#include "pipeline/splat/draw/device_picture.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// The pictures that the compositor mixes. Each is linear premultiplied RGBA of `sizePx`; a null pointer means
// that there is none.
struct Layers {
    const splat::DevicePicture* splats = nullptr;
    const ReprojectedPicture* fovea = nullptr;   // over the splats, by its weights
    const trace::TracedLight* traced = nullptr;  // with all pixels
    // float for each pixel: the trust in `traced` over the splats (trust.h). Null: full trust.
    const gpu::TexelBuffer* tracedTrusts = nullptr;
    glm::ivec2 sizePx{0};
    float splatGain = 1.0f;  // multiplies their light, not their coverage
    // 0 to 1: the share of `traced`, which splats replace where it is not trusted; the rest is splats and
    // fovea. Must be 1 without splats, and 0 without `traced`.
    float tracedShare = 0.0f;
};

struct Display {
    glm::vec3 background{0.0f};  // in linear light, neither exposed nor tone-mapped
    float exposure = 1.0f;
    trace::ToneMap toneMap = trace::ToneMap::neutral;
    // The picture is premultiplied (as linear light) and has the coverage as alpha; there is no background.
    bool keepsCoverage = false;
};

// Used by one thread at a time, the one that uses the device. No pixels pass through the host, and no call
// waits for the device.
class Compositor {
  public:
    static Result<Compositor> create(const std::shared_ptr<gpu::Device>& device);

    // Mixes the layers as light (shaders/lib/compose.glsl), lays them over the background, exposes, tone maps
    // and encodes as PathTracer::display does: RGBA8, opaque unless coverage is kept, in layout GENERAL,
    // valid until the next picture of another size. Fails with outOfMemory.
    Result<const gpu::Image*> compose(const Layers& layers, const Display& display);

  private:
    Compositor(std::shared_ptr<gpu::Device> device, gpu::TexelBuffer nothing)
        : device_(std::move(device)), nothing_(std::move(nothing)) {}
    Result<gpu::Kernel> kernelFor(const Layers& layers, const Display& display) const;

    std::shared_ptr<gpu::Device> device_;
    gpu::TexelBuffer nothing_;  // bound in place of missing layers
    std::optional<gpu::Image> picture_;
};

}  // namespace macula::hybrid
