// A picture on the device: premultiplied RGBA in float, row 0 on top. The rasterizer draws it and the loss
// compares it; the gradient with respect to such a picture has the same form.
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
    // vec4 for each pixel, at y * width + x; the buffer may have room for more. Kernels write it as a storage
    // buffer and read it as a samplerBuffer.
    gpu::TexelBuffer texels;

    // Makes a picture without content. Sizes above 0; outOfMemory when the device cannot hold 16 bytes for
    // each pixel.
    static Result<DevicePicture> create(const std::shared_ptr<gpu::Device>& device, const std::string& label,
                                        int width, int height);
    // Makes a picture of `pixels`, uploaded after all work submitted so far.
    static Result<DevicePicture> upload(const std::shared_ptr<gpu::Device>& device, const std::string& label,
                                        int width, int height, std::span<const glm::vec4> pixels);

    // Reads the pixels back. Waits.
    Result<std::vector<glm::vec4>> read() const;
};

}  // namespace macula::splat
