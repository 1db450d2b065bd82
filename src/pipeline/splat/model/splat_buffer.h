// The parameters of splats on the device, or a number for each parameter, such as a gradient or a moment.
// Their order: shaders/shared/splat_layout.h.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/splat/model/splat_components.h"

namespace macula::splat {

class SplatBuffer {
  public:
    // A buffer of zeros. Capacity above 0; outOfMemory when the device has no room, or capacity *
    // componentCount floats exceed its largest buffer (on lavapipe 128 MiB: 2.3 million splats of degree 0,
    // 1.4 million of degree 1).
    static Result<SplatBuffer> create(const std::shared_ptr<gpu::Device>& device, const std::string& label,
                                      std::uint32_t capacity, int shDegree);

    std::uint32_t capacity() const { return capacity_; }
    int shDegree() const { return shDegree_; }
    int components() const { return componentCount(shDegree_); }
    // Float for each component of each splat up to the capacity. Kernels write it as a storage buffer, and
    // read it as a storage buffer or samplerBuffer.
    const gpu::TexelBuffer& values() const { return values_; }

    // Uploads component k of splat i from k * count + i, as componentsOf gives them; splats from `count` on
    // become 0. Ordered after all work submitted so far.
    Result<void> upload(std::span<const float> components);
    // Returns the components of the first `count` splats, at most the capacity. Waits.
    Result<std::vector<float>> download(std::uint32_t count) const;

  private:
    SplatBuffer(std::uint32_t capacity, int shDegree, gpu::TexelBuffer values)
        : capacity_(capacity), shDegree_(shDegree), values_(std::move(values)) {}

    std::uint32_t capacity_;
    int shDegree_;
    gpu::TexelBuffer values_;
};

}  // namespace macula::splat
