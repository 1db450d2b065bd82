// A picture on the device: premultiplied RGBA in float, row 0 on top. What the rasterizer draws, the loss
// compares, and a gradient with respect to such a picture.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/resources.h"

namespace macula::splat {

struct DevicePicture {
    int width = 0;
    int height = 0;
    // vec4 for each pixel, y * width + x; there may be room for more. Kernels write it as a storage buffer
    // and read it as a samplerBuffer.
    gpu::TexelBuffer texels;

    // A picture that is not initialised. Sizes above 0; outOfMemory when the device cannot hold 16 bytes for
    // each pixel.
    static Result<DevicePicture> create(const std::shared_ptr<gpu::Device>& device, const std::string& label,
                                        int width, int height);
    // Ordered after all work submitted so far.
    static Result<DevicePicture> upload(const std::shared_ptr<gpu::Device>& device, const std::string& label,
                                        int width, int height, std::span<const glm::vec4> pixels);

    // Waits.
    Result<std::vector<glm::vec4>> read() const;
};

}  // namespace macula::splat
