#include "pipeline/hybrid/frame/compositor.h"

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "shaders/hybrid.h"
#include "shared/compose_params.h"

namespace macula::hybrid {

Result<Compositor> Compositor::create(const std::shared_ptr<gpu::Device>& device) {
    MACULA_TRY(gpu::TexelBuffer nothing,
               gpu::TexelBuffer::create(device, {.label = "no layer",
                                                 .elements = 1,
                                                 .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                                 .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
                                                          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}));
    return Compositor(device, std::move(nothing));
}

// Cheap after the first call: the device keeps compiled kernels.
Result<gpu::Kernel> Compositor::kernelFor(const Layers& layers, const Display& display) const {
    const bool isMixed = layers.tracedShare < 1.0f;
    const bool isTrusted = layers.tracedTrusts == nullptr || layers.tracedShare <= 0.0f;
    return gpu::Kernel::create(
        device_, shaders::hybrid_compose_comp,
        {.specializations = {{"kHasSplats", layers.splats != nullptr && (isMixed || !isTrusted)},
                             {"kHasFovea", layers.fovea != nullptr && isMixed},
                             {"kHasTraced", layers.tracedShare > 0.0f},
                             {"kHasTrusts", !isTrusted},
                             {"kKeepsCoverage", display.keepsCoverage}}});
}

Result<const gpu::Image*> Compositor::compose(const Layers& layers, const Display& display) {
    MACULA_CHECK(layers.splats != nullptr || (layers.tracedShare >= 1.0f && layers.tracedTrusts == nullptr));
    MACULA_CHECK(layers.traced != nullptr || layers.tracedShare <= 0.0f);
    const auto width = static_cast<std::uint32_t>(layers.sizePx.x);
    const auto height = static_cast<std::uint32_t>(layers.sizePx.y);
    if (layers.splats != nullptr) {
        MACULA_CHECK_EQ(layers.splats->width, layers.sizePx.x);
        MACULA_CHECK_EQ(layers.splats->height, layers.sizePx.y);
    }
    if (layers.traced != nullptr)
        MACULA_CHECK_LE(std::uint64_t(width) * height * sizeof(glm::vec4), layers.traced->values->bytes());
    if (!picture_ || picture_->extent().width != width || picture_->extent().height != height) {
        picture_.reset();
        MACULA_TRY(picture_, gpu::Image::create(device_, {.label = "composed picture",
                                                          .width = width,
                                                          .height = height,
                                                          .format = VK_FORMAT_R8G8B8A8_UNORM}));
    }
    // Each binding needs a buffer, even if the kernel does not read it.
    const gpu::TexelBuffer& splats = layers.splats != nullptr ? layers.splats->texels : nothing_;
    const gpu::TexelBuffer& fovea = layers.fovea != nullptr ? *layers.fovea->lights : nothing_;
    const gpu::TexelBuffer& weights = layers.fovea != nullptr ? *layers.fovea->weights : nothing_;
    const gpu::TexelBuffer& trusts = layers.tracedTrusts != nullptr ? *layers.tracedTrusts : nothing_;
    const gpu::Buffer& values = layers.traced != nullptr ? *layers.traced->values : nothing_.buffer();
    const gpu::Buffer& counts = layers.traced != nullptr ? *layers.traced->counts : nothing_.buffer();
    const shared::ComposePush push{
        .background = display.background,
        .exposure = display.exposure,
        .splatGain = layers.splatGain,
        .tracedShare = layers.tracedShare,
        .tracedAreMeans = layers.traced != nullptr && layers.traced->areMeans ? 1 : 0,
        .keepsHue = display.toneMap == trace::ToneMap::hue ? 1 : 0};
    MACULA_TRY(const gpu::Kernel kernel, kernelFor(layers, display));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "compose"));
    recorder.dispatch(kernel, {width, height}, push,
                      {splats, fovea, weights, values, counts, trusts, *picture_});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return &*picture_;
}

}  // namespace macula::hybrid
