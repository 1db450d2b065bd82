// How noisy each block of a picture is so far, estimated on the device from its samples.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/film.h"
#include "pipeline/trace/settings.h"
#include "shared/trace_params.h"

namespace macula::trace {

// A noise map for one size of picture. Used by one thread at a time, the one that uses the device.
class NoiseMap {
  public:
    static Result<NoiseMap> create(const std::shared_ptr<gpu::Device>& device, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    // Starts to measure again, from the first block; earlier results are void.
    void begin() { measured_ = 0; }
    bool isWhole() const { return measured_ == blocks_; }
    // One short dispatch over the next blocks; on a graphics card usually over all that are left. Waits.
    Result<void> measureSome(const Film& film, const Settings& settings);
    // The noise of each block of the picture, row by row; waits. Only when whole.
    Result<std::vector<shared::BlockNoise>> read() const;

  private:
    NoiseMap(int width, int height, std::uint32_t blocks, gpu::Kernel kernel, gpu::Buffer noises)
        : width_(width),
          height_(height),
          blocks_(blocks),
          kernel_(std::move(kernel)),
          noises_(std::move(noises)) {}

    int width_;
    int height_;
    std::uint32_t blocks_;
    std::uint32_t measured_ = 0;
    gpu::Kernel kernel_;
    gpu::Buffer noises_;  // BlockNoise
};

}  // namespace macula::trace
