// Adam (Kingma and Ba 2015) on the device, for the visible splats.
//
// Only splats with a gradient move: those that the view showed. The others keep their moments as well,
// because a view says nothing about what it does not show. The moments' bias towards 0 is corrected by the
// number of steps of each splat, not of the model: a splat that is added late starts as fast as the first
// ones did.
#pragma once

#include <cstdint>
#include <memory>

#include "base/result.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/splat/model/splat_buffer.h"
#include "pipeline/splat/train/optimizer_options.h"
#include "pipeline/splat/train/optimizer_state.h"

namespace macula::splat {

// Used by one thread at a time, the one that uses the device.
class Optimizer {
  public:
    // For models of up to `capacity` splats, and of that degree. usage when an option is out of its range;
    // outOfMemory as SplatBuffer::create, for two of them.
    static Result<Optimizer> create(const std::shared_ptr<gpu::Device>& device, std::uint32_t capacity,
                                    int shDegree, const OptimizerOptions& options);

    // Records one step of those of the first `count` splats whose entry in `visible`, a uint for each, is not
    // 0. Splats with a gradient that is not finite, or beyond 1e18, stay as they are and are counted. Counts
    // as a step when recorded, so it must be submitted.
    void record(gpu::Recorder& recorder, SplatBuffer& parameters, const SplatBuffer& gradients,
                const gpu::Buffer& visible, std::uint32_t count);

    // Uncounts the last recorded step, because nothing was visible in it.
    void takeBack() { --stepsDone_; }

    // How often a splat was left out because of its gradient, since the start. Waits.
    Result<std::uint32_t> skipped() const;

    std::uint64_t stepsDone() const { return stepsDone_; }
    // Reads back the moments and steps of the first `count` splats. Waits.
    Result<OptimizerState> download(std::uint32_t count) const;
    // Splats from steps.size() on start from 0. Fails with inputNotUsable when the arrays do not match each
    // other or do not fit.
    Result<void> upload(const OptimizerState& state);

  private:
    Optimizer(const OptimizerOptions& options, gpu::Kernel kernel, SplatBuffer first, SplatBuffer second,
              gpu::Buffer steps, gpu::Buffer skipped, gpu::Buffer params, gpu::TexelBuffer corrections);

    OptimizerOptions options_;
    gpu::Kernel kernel_;
    SplatBuffer first_;
    SplatBuffer second_;
    gpu::Buffer steps_;
    gpu::Buffer skipped_;
    gpu::Buffer params_;
    gpu::TexelBuffer corrections_;  // vec2 for each number of steps of a splat
    std::uint64_t stepsDone_ = 0;
};

}  // namespace macula::splat
