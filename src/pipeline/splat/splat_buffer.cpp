#include "pipeline/splat/splat_buffer.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::splat {

namespace {

// body(component, number) for each parameter of a splat; the order of shared/splat_layout.h.
template <class Model, class Body>
void forEachParameter(Model& splats, std::size_t i, const Body& body) {
    using namespace shared;
    for (int c = 0; c < 3; ++c) body(kSplatPosition + c, splats.position[i][c]);
    for (int c = 0; c < 3; ++c) body(kSplatLogScale + c, splats.logScale[i][c]);
    for (int c = 0; c < 4; ++c) body(kSplatRotation + c, splats.rotation[i][c]);
    body(kSplatOpacity, splats.opacityLogit[i]);
    for (int c = 0; c < 3; ++c) body(kSplatDc + c, splats.dc[i][c]);
    const std::size_t perSplat = shCount(splats.shDegree);
    for (std::size_t k = 0; k < perSplat; ++k)
        for (int c = 0; c < 3; ++c)
            body(kSplatSh + 3 * static_cast<int>(k) + c, splats.sh[i * perSplat + k][c]);
}

}  // namespace

std::vector<float> componentsOf(const Splats& splats) {
    const std::size_t count = splats.size();
    std::vector<float> components(count * static_cast<std::size_t>(componentCount(splats.shDegree)));
    for (std::size_t i = 0; i < count; ++i)
        forEachParameter(splats, i, [&](int component, float number) {
            components[static_cast<std::size_t>(component) * count + i] = number;
        });
    return components;
}

Splats splatsOf(std::span<const float> components, const Splats& like) {
    const auto perSplat = static_cast<std::size_t>(componentCount(like.shDegree));
    MACULA_CHECK_EQ(components.size() % perSplat, 0u);
    const std::size_t count = components.size() / perSplat;
    Splats splats{.originMm = like.originMm,
                  .axes = like.axes,
                  .colourSpace = like.colourSpace,
                  .lowPass = like.lowPass,
                  .shDegree = like.shDegree};
    splats.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        forEachParameter(splats, i, [&](int component, float& number) {
            number = components[static_cast<std::size_t>(component) * count + i];
        });
    return splats;
}

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
