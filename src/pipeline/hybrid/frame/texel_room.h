// Texels that kernels write, and read through a samplerBuffer.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"

namespace macula::hybrid {

inline Result<gpu::TexelBuffer> makeTexels(const std::shared_ptr<gpu::Device>& device, const char* label,
                                           VkFormat format, std::uint64_t elements) {
    return gpu::TexelBuffer::create(
        device, {.label = label,
                 .elements = elements,
                 .format = format,
                 .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
}

// Makes room for at least so many elements. If there was less, the old contents are lost.
inline Result<void> makeRoom(std::optional<gpu::TexelBuffer>& texels,
                             const std::shared_ptr<gpu::Device>& device, const char* label, VkFormat format,
                             std::uint64_t elements) {
    if (texels && texels->elements() >= elements) return {};
    texels.reset();
    MACULA_TRY(texels, makeTexels(device, label, format, elements));
    return {};
}

}  // namespace macula::hybrid
