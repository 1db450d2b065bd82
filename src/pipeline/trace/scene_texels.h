// Tables of a scene, as kernels read them.
#pragma once

#include <memory>
#include <span>

#include "base/result.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/gpu/transfer.h"

namespace macula::trace {

template <class T>
Result<gpu::TexelBuffer> uploadedTexels(const std::shared_ptr<gpu::Device>& device, const char* label,
                                        VkFormat format, std::span<const T> values) {
    MACULA_TRY(auto texels, gpu::TexelBuffer::create(
                                device, {.label = label, .elements = values.size(), .format = format}));
    MACULA_TRY_VOID(gpu::uploadTo(texels.buffer(), values));
    return texels;
}

}  // namespace macula::trace
