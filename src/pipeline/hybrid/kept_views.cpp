#include "pipeline/hybrid/kept_views.h"

#include <span>
#include <string>
#include <utility>

#include "base/sha256.h"
#include "shaders/trace.h"

namespace macula::hybrid {

namespace {

// Of all kernels besides the tracer's own that such a picture depends on.
const std::string& kernelsDigest() {
    static const std::string digest = [] {
        std::string text;
        for (const gpu::ShaderCode* code : {&shaders::trace_guides_comp, &shaders::denoise_gather_comp,
                                            &shaders::denoise_prepare_comp, &shaders::denoise_filter_comp})
            text += sha256Hex(std::as_bytes(std::span(code->words)));
        return sha256Hex(text);
    }();
    return digest;
}

// Grows when what readToLearnFrom makes of them on the host becomes another.
constexpr int kVersion = 1;

// Not that of a picture to compare with, whose coverage is that of its samples.
Result<std::string> keyOf(const TracedScene& scene, const trace::View& view, const trace::Settings& settings,
                          std::uint32_t samplesPerPixel) {
    MACULA_TRY(const std::string traced, scene.pictureKey(view, settings, samplesPerPixel));
    return sha256Hex(fmt::format("to learn from {} {} {}", kVersion, traced, kernelsDigest()));
}

}  // namespace

Result<std::optional<TracedView>> KeptViews::find(const trace::View& view, const trace::Settings& settings,
                                                  std::uint32_t samplesPerPixel) const {
    MACULA_TRY(const std::string key, keyOf(scene_, view, settings, samplesPerPixel));
    std::optional<KeptPicture> kept = cache_.find(key);
    if (!kept || kept->sizePx != glm::ivec2(view.width, view.height)) return std::optional<TracedView>();
    return std::optional(TracedView{.camera = view.camera,
                                    .sizePx = kept->sizePx,
                                    .rgba = std::move(kept->rgba),
                                    .samplesPerPixel = double(samplesPerPixel)});
}

Result<void> KeptViews::keep(const trace::View& view, const trace::Settings& settings,
                             std::uint32_t samplesPerPixel, const TracedView& traced) const {
    MACULA_TRY(const std::string key, keyOf(scene_, view, settings, samplesPerPixel));
    return cache_.keep(key, {.sizePx = traced.sizePx, .rgba = traced.rgba});
}

}  // namespace macula::hybrid
