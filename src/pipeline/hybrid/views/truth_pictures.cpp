#include "pipeline/hybrid/views/truth_pictures.h"

#include <algorithm>
#include <utility>

#include "pipeline/hybrid/views/view_tracing.h"

namespace macula::hybrid {

namespace {

// The seeds of the two halves. No training view has a seed near them.
constexpr std::array<std::uint32_t, 2> kSeeds{0x7247, 0x17247};

struct Half {
    TracedView view;
    bool fromCache = false;
};

Result<Half> makeHalf(trace::PathTracer& tracer, const TracedScene& scene, const trace::View& view,
                      const trace::Settings& settings, std::uint32_t samples, const PictureCache& cache,
                      Progress& progress) {
    const glm::ivec2 size{view.width, view.height};
    MACULA_TRY(const std::string key, scene.pictureKey(view, settings, samples));
    if (auto kept = cache.find(key); kept && kept->sizePx == size) {
        progress.advance(samples);
        return Half{.view = {.camera = view.camera,
                             .sizePx = size,
                             .rgba = std::move(kept->rgba),
                             .samplesPerPixel = double(samples)},
                    .fromCache = true};
    }
    MACULA_TRY(TracedView traced, traceView(tracer, view, settings, samples, progress));
    MACULA_TRY_VOID(cache.keep(key, {.sizePx = size, .rgba = traced.rgba}));
    return Half{.view = std::move(traced)};
}

}  // namespace

std::vector<glm::vec4> TruthPicture::whole() const {
    std::vector<glm::vec4> mean(halves[0].rgba.size());
    std::transform(halves[0].rgba.begin(), halves[0].rgba.end(), halves[1].rgba.begin(), mean.begin(),
                   [](const glm::vec4& a, const glm::vec4& b) { return 0.5f * (a + b); });
    return mean;
}

Result<std::vector<TruthPicture>> truthPictures(trace::PathTracer& tracer, const TracedScene& scene,
                                                std::span<const Camera> cameras, const TruthOptions& options,
                                                const PictureCache& cache, Progress& progress) {
    if (options.samplesPerPixel < 2 || options.samplesPerPixel % 2 != 0)
        return Error{ErrorCode::usage, Text("The samples of what is compared with cannot be halved."),
                     fmt::format("{}", options.samplesPerPixel), Text("Give an even number of them.")};
    MACULA_TRY_VOID(cache.prepare());
    progress.beginStage(Text("Tracing what is compared with"), cameras.size() * options.samplesPerPixel);
    std::vector<TruthPicture> pictures;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const trace::View view{.camera = cameras[i], .width = options.sizePx.x, .height = options.sizePx.y};
        TruthPicture picture{.halves = {}, .fromCache = true};
        for (std::size_t k = 0; k < picture.halves.size(); ++k) {
            const trace::Settings settings{.bounces = options.bounces,
                                           .seed = kSeeds[k] + static_cast<std::uint32_t>(i),
                                           .exposure = options.exposure};
            MACULA_TRY(Half half,
                       makeHalf(tracer, scene, view, settings, options.samplesPerPixel / 2, cache, progress));
            picture.halves[k] = std::move(half.view);
            picture.fromCache = picture.fromCache && half.fromCache;
        }
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace macula::hybrid
