// Feature buffers of a picture (a G-buffer: depth, normal, albedo, motion), called guides: for denoising it,
// for warping it to another eye, for measuring in it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/guide_pixel.h"

namespace macula::trace {

class SceneView;

// Lie on the device, row 0 on top. Used by one thread at a time, the one that uses the device.
class Guides {
  public:
    static Result<Guides> create(const std::shared_ptr<gpu::Device>& device, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    // Begins another picture, of which no row is computed yet.
    void begin() { rows_ = 0; }
    bool isWhole() const { return rows_ >= height_; }
    // Computes the rows that are left, for the view of `scene`, by guides.comp as compiled for that scene
    // (TraceKernels). Motion is towards `before`; the picture's own view gives no motion. Calls `keepGoing`
    // between dispatches of some 40 ms, and waits for each; when it returns false, the next call continues
    // there. With an empty `keepGoing` it waits for nothing.
    Result<void> compute(const SceneView& scene, const gpu::Kernel& kernel, const shared::GuidePush& before,
                         const std::function<bool()>& keepGoing = {});

    // vec4 for each pixel, as buffers and as texels.
    const gpu::TexelBuffer& surfaces() const { return surfaces_; }  // normal, depth
    const gpu::TexelBuffer& matters() const { return matters_; }    // albedo, coverage
    const gpu::TexelBuffer& motions() const { return motions_; }    // motion, confidence, distance before

    Result<std::vector<GuidePixel>> read() const;     // waits
    Result<std::vector<float>> readCoverage() const;  // waits; a third of the bytes of read()

  private:
    Guides(int width, int height, gpu::TexelBuffer surfaces, gpu::TexelBuffer matters,
           gpu::TexelBuffer motions);

    int width_;
    int height_;
    int rows_ = 0;  // computed so far
    gpu::TexelBuffer surfaces_;
    gpu::TexelBuffer matters_;
    gpu::TexelBuffer motions_;
};

}  // namespace macula::trace
