#include "pipeline/splat/model/splat_buffer.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::splat {

Result<SplatBuffer> SplatBuffer::create(const std::shared_ptr<gpu::Device>& device, const std::string& label,
                                        std::uint32_t capacity, int shDegree) {
    MACULA_CHECK(shDegree >= 0 && shDegree <= kMaxShDegree);
    MACULA_TRY(gpu::TexelBuffer values,
               gpu::TexelBuffer::create(
                   device,
                   {.label = label,
                    .elements = std::uint64_t(capacity) * std::uint64_t(componentCount(shDegree)),
                    .format = VK_FORMAT_R32_SFLOAT,
                    .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, label));
    recorder.fill(values.buffer(), 0);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return SplatBuffer(capacity, shDegree, std::move(values));
}

Result<void> SplatBuffer::upload(std::span<const float> components) {
    const auto perSplat = static_cast<std::size_t>(this->components());
    MACULA_CHECK_EQ(components.size() % perSplat, 0u);
    const std::size_t count = components.size() / perSplat;
    MACULA_CHECK_LE(count, capacity_);
    std::vector<float> spread(perSplat * capacity_, 0.0f);
    for (std::size_t k = 0; k < perSplat; ++k)
        std::copy_n(components.begin() + std::ptrdiff_t(k * count), count,
                    spread.begin() + std::ptrdiff_t(k * capacity_));
    return gpu::uploadTo<float>(values_.buffer(), spread);
}

Result<std::vector<float>> SplatBuffer::download(std::uint32_t count) const {
    MACULA_CHECK_LE(count, capacity_);
    MACULA_TRY(const std::vector<float> spread, gpu::read<float>(values_.buffer()));
    const auto perSplat = static_cast<std::size_t>(components());
    std::vector<float> result(perSplat * count);
    for (std::size_t k = 0; k < perSplat; ++k)
        std::copy_n(spread.begin() + std::ptrdiff_t(k * capacity_), count,
                    result.begin() + std::ptrdiff_t(k * count));
    return result;
}

}  // namespace macula::splat
