#include "pipeline/splat/draw/device_picture.h"

#include <utility>

#include "base/check.h"
#include "pipeline/gpu/transfer.h"

namespace macula::splat {

Result<DevicePicture> DevicePicture::create(const std::shared_ptr<gpu::Device>& device,
                                            const std::string& label, int width, int height) {
    MACULA_CHECK_LT(0, width);
    MACULA_CHECK_LT(0, height);
    MACULA_TRY(gpu::TexelBuffer texels,
               gpu::TexelBuffer::create(device, {.label = label,
                                                 .elements = std::uint64_t(width) * std::uint64_t(height),
                                                 .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                                 .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
                                                          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}));
    return DevicePicture{width, height, std::move(texels)};
}

Result<DevicePicture> DevicePicture::upload(const std::shared_ptr<gpu::Device>& device,
                                            const std::string& label, int width, int height,
                                            std::span<const glm::vec4> pixels) {
    MACULA_CHECK_EQ(pixels.size(), std::size_t(width) * std::size_t(height));
    MACULA_TRY(DevicePicture picture, create(device, label, width, height));
    MACULA_TRY_VOID(gpu::uploadTo<glm::vec4>(picture.texels.buffer(), pixels));
    return picture;
}

Result<std::vector<glm::vec4>> DevicePicture::read() const {
    std::vector<glm::vec4> pixels(std::size_t(width) * std::size_t(height));
    MACULA_TRY_VOID(gpu::readInto(texels.buffer(), 0, std::as_writable_bytes(std::span(pixels))));
    return pixels;
}

}  // namespace macula::splat
