#include "pipeline/hybrid/frame/eye_depths.h"

#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "shaders/hybrid.h"
#include "shared/eye_depth_params.h"

namespace macula::hybrid {

Result<EyeDepths> EyeDepths::create(const std::shared_ptr<gpu::Device>& device) {
    MACULA_TRY(gpu::Kernel kernel, gpu::Kernel::create(device, shaders::hybrid_eye_depth_comp));
    return EyeDepths(device, std::move(kernel));
}

Result<const gpu::Buffer*> EyeDepths::make(std::size_t eye, const DrawnSplats& splats,
                                           const DepthRange& range) {
    MACULA_CHECK(splats.picture != nullptr && splats.depthSums != nullptr);
    MACULA_CHECK(range.nearest > 0.0f && range.farthest > range.nearest);
    const glm::ivec2 sizePx(splats.picture->width, splats.picture->height);
    const std::uint64_t bytes = std::uint64_t(sizePx.x) * std::uint64_t(sizePx.y) * sizeof(float);
    MACULA_CHECK_LE(bytes, splats.depthSums->bytes());
    while (depths_.size() <= eye) {
        MACULA_TRY(gpu::Buffer buffer,
                   gpu::Buffer::create(device_, {.label = "depths of an eye", .bytes = bytes}));
        depths_.push_back(std::move(buffer));
    }
    if (depths_[eye].bytes() < bytes) {
        MACULA_TRY(depths_[eye], gpu::Buffer::create(device_, {.label = "depths of an eye", .bytes = bytes}));
    }
    const shared::EyeDepthPush push{
        .size = sizePx, .unitsPerMm = range.unitsPerMm, .nearest = range.nearest, .farthest = range.farthest};
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "depths of an eye"));
    recorder.dispatch(kernel_, {static_cast<std::uint32_t>(sizePx.x), static_cast<std::uint32_t>(sizePx.y)},
                      push, {splats.picture->texels, *splats.depthSums, depths_[eye]});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return &depths_[eye];
}

}  // namespace macula::hybrid
