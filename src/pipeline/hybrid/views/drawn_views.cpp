#include "pipeline/hybrid/views/drawn_views.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/elapsed.h"
#include "pipeline/splat/draw/rasterizer.h"

namespace macula::hybrid {

Result<DrawnViews> drawViews(const std::shared_ptr<gpu::Device>& device, const splat::Splats& splats,
                             std::span<const Camera> cameras, const glm::ivec2& sizePx) {
    MACULA_TRY_VOID(splats.validate());
    const auto count = static_cast<std::uint32_t>(splats.size());
    const std::uint32_t capacity = std::max(count, 1u);
    MACULA_TRY(splat::SplatBuffer parameters,
               splat::SplatBuffer::create(device, "model", capacity, splats.shDegree));
    MACULA_TRY_VOID(parameters.upload(splat::componentsOf(splats)));
    MACULA_TRY(splat::Rasterizer rasterizer, splat::Rasterizer::create(device, capacity, splats.shDegree));
    const splat::Blending blending = splat::blendingOf(splats.lowPass);
    DrawnViews drawn;
    for (const Camera& camera : cameras) {
        MACULA_TRY(const splat::RasterView view, splat::rasterView(camera, sizePx, splats.originMm));
        const auto start = std::chrono::steady_clock::now();
        MACULA_TRY_VOID(rasterizer.draw(parameters, count, view, blending));
        MACULA_TRY_VOID(device->waitForAll());
        drawn.milliseconds.push_back(msSince(start));
        MACULA_TRY(std::vector<glm::vec4> picture, rasterizer.picture().read());
        drawn.pictures.push_back(std::move(picture));
    }
    return drawn;
}

}  // namespace macula::hybrid
