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

// On the device; row 0 on top. Used by one thread at a time, the one that uses the device.
class Guides {
  public:
    static Result<Guides> create(const std::shared_ptr<gpu::Device>& device, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    // Another picture: nothing of it is known yet.
    void begin() { rows_ = 0; }
    bool isWhole() const { return rows_ >= height_; }
    // Computes the rows that are left of the view of `scene`, by guides.comp as compiled for it
    // (TraceKernels). Motion is towards `before`; the picture's own view gives none. `keepGoing` is asked
    // between dispatches of some 40 ms, which are waited for, and the next call goes on where it said no;
    // when it is empty nothing is waited for.
    Result<void> compute(const SceneView& scene, const gpu::Kernel& kernel, const shared::GuidePush& before,
                         const std::function<bool()>& keepGoing = {});

    // vec4 for each pixel, as buffers and as texels.
    const gpu::TexelBuffer& surfaces() const { return surfaces_; }  // normal, depth
    const gpu::TexelBuffer& matters() const { return matters_; }    // albedo, coverage
    const gpu::TexelBuffer& motions() const { return motions_; }    // motion, confidence, distance before

    Result<std::vector<GuidePixel>> read() const;     // waits
    Result<std::vector<float>> readCoverage() const;  // likewise: a third of the bytes

  private:
    Guides(int width, int height, gpu::TexelBuffer surfaces, gpu::TexelBuffer matters,
           gpu::TexelBuffer motions);

    int width_;
    int height_;
    int rows_ = 0;  // that are computed
    gpu::TexelBuffer surfaces_;
    gpu::TexelBuffer matters_;
    gpu::TexelBuffer motions_;
};

}  // namespace macula::trace
