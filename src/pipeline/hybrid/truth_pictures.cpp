#include "pipeline/hybrid/truth_pictures.h"

#include <utility>

#include "pipeline/hybrid/traced_views.h"

namespace macula::hybrid {

namespace {

Result<TruthPicture> makeOne(trace::PathTracer& tracer, const trace::View& view,
                             const trace::Settings& settings, std::uint32_t samples, Progress& progress) {
    MACULA_TRY(TracedView traced, traceView(tracer, view, settings, samples, progress));
    MACULA_TRY(const trace::ErrorEstimate error, tracer.estimateError());
    return TruthPicture{.view = std::move(traced), .noise = error.rms};
}

}  // namespace

Result<std::vector<TruthPicture>> truthPictures(trace::PathTracer& tracer, const TracedScene& scene,
                                                std::span<const Camera> cameras, const TruthOptions& options,
                                                const PictureCache& cache, Progress& progress) {
    MACULA_TRY_VOID(cache.prepare());
    constexpr std::uint32_t kSeed = 0x7247;  // no training view has one near it
    const glm::ivec2 size = options.sizePx;
    progress.beginStage("Tracing what is compared with", cameras.size() * options.samplesPerPixel);
    std::vector<TruthPicture> pictures;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const trace::View view{.camera = cameras[i], .width = size.x, .height = size.y};
        const trace::Settings settings{.bounces = options.bounces,
                                       .seed = kSeed + static_cast<std::uint32_t>(i),
                                       .exposure = options.exposure};
        MACULA_TRY(const std::string key, scene.pictureKey(view, settings, options.samplesPerPixel));
        if (auto kept = cache.find(key); kept && kept->sizePx == size) {
            pictures.push_back({.view = {.camera = cameras[i],
                                         .sizePx = size,
                                         .rgba = std::move(kept->rgba),
                                         .samplesPerPixel = double(options.samplesPerPixel)},
                                .noise = kept->noise,
                                .fromCache = true});
            progress.advance(options.samplesPerPixel);
            continue;
        }
        MACULA_TRY(TruthPicture made, makeOne(tracer, view, settings, options.samplesPerPixel, progress));
        MACULA_TRY_VOID(cache.keep(key, {.sizePx = size, .rgba = made.view.rgba, .noise = made.noise}));
        pictures.push_back(std::move(made));
    }
    return pictures;
}

}  // namespace macula::hybrid
