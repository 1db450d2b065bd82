#include "pipeline/hybrid/frame/trust.h"

#include <cstdint>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "shaders/hybrid.h"
#include "shared/reproject_params.h"

namespace macula::hybrid {

Result<Trust> Trust::create(const std::shared_ptr<gpu::Device>& device) {
    MACULA_TRY(gpu::Kernel rows, gpu::Kernel::create(device, shaders::hybrid_trust_rows_comp));
    MACULA_TRY(gpu::Kernel trust, gpu::Kernel::create(device, shaders::hybrid_trust_comp));
    return Trust(device, std::move(rows), std::move(trust));
}

Result<void> Trust::weigh(const trace::TracedLight& traced, const splat::DevicePicture& splats,
                          float splatGain, const gpu::TexelBuffer& trusts) {
    const std::uint64_t pixels = std::uint64_t(splats.width) * std::uint64_t(splats.height);
    MACULA_CHECK_LE(pixels * sizeof(glm::vec4), traced.values->bytes());
    MACULA_CHECK_LE(pixels * sizeof(float), traced.variances->bytes());
    MACULA_CHECK_LE(pixels, trusts.elements());
    if (!terms_ || terms_->bytes() < pixels * sizeof(glm::vec2)) {
        terms_.reset();
        MACULA_TRY(terms_, gpu::Buffer::create(
                               device_, {.label = "terms of trust", .bytes = pixels * sizeof(glm::vec2)}));
    }
    const gpu::Threads threads{static_cast<std::uint32_t>(splats.width),
                               static_cast<std::uint32_t>(splats.height)};
    const shared::TrustPush push{
        .size = {splats.width, splats.height}, .areMeans = traced.areMeans ? 1 : 0, .splatGain = splatGain};
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "trust"));
    recorder.dispatch(rows_, threads, push,
                      {*traced.values, *traced.counts, *traced.variances, splats.texels, *terms_});
    recorder.dispatch(trust_, threads, push, {*terms_, trusts.buffer()});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return {};
}

}  // namespace macula::hybrid
