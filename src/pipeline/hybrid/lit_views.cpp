#include "pipeline/hybrid/lit_views.h"

#include <cstddef>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "pipeline/hybrid/pixel_coverage.h"

namespace macula::hybrid {

namespace {

// Rays of a pixel, through places in it and to depths in matter by chance: more say little more.
constexpr std::uint32_t kRays = 8;
static_assert(kRays % shared::kPrimarySamples == 0);

// What rays of a pixel have found.
struct Found {
    glm::dvec3 light{0.0};
    std::uint32_t lit = 0;   // rays
    std::uint32_t dark = 0;  // that met matter of which nothing is known
};

void lookUp(std::span<const shared::PrimaryVertex> met, const glm::dvec3& eyeMm, const LightInSpace& light,
            std::vector<Found>& found) {
    constexpr std::size_t kAtOnce = 1024;
    const std::size_t pixels = found.size();
    parallelFor((pixels + kAtOnce - 1) / kAtOnce, [&](std::size_t part) {
        for (std::size_t n = 0; n < met.size(); n += pixels) {
            for (std::size_t i = part * kAtOnce; i < std::min((part + 1) * kAtOnce, pixels); ++i) {
                const shared::PrimaryVertex& vertex = met[n + i];
                const glm::dvec3 way(vertex.fromEyeMm);
                if (way == glm::dvec3(0.0)) continue;
                // A grey face of a clip shows the same to all.
                const bool isFace = vertex.radiance != glm::vec3(0.0f);
                const auto known =
                    isFace ? std::optional(vertex.radiance) : light.at(eyeMm + way, glm::normalize(way));
                found[i].light += glm::dvec3(known.value_or(glm::vec3(0.0f)));
                ++(known ? found[i].lit : found[i].dark);
            }
        }
    });
}

// Light as far as it is known, for all rays that met matter; nothing is known where it is not of most.
glm::vec4 pixelOf(const Found& found, float coverage) {
    if (found.dark > found.lit) return glm::vec4(std::numeric_limits<float>::quiet_NaN());
    const double met = double(found.lit + found.dark) / double(kRays);
    return {found.lit > 0 ? glm::vec3(found.light / double(found.lit) * met) : glm::vec3(0.0f), coverage};
}

}  // namespace

Result<std::vector<TracedView>> litViews(trace::PathTracer& tracer, std::span<const Camera> cameras,
                                         const glm::ivec2& sizePx, const trace::Settings& settings,
                                         const LightInSpace& light, Progress& progress) {
    progress.beginStage("Lighting other sides", cameras.size());
    const auto keepGoing = [&] { return !progress.cancelled(); };
    trace::Settings mine = settings;
    mine.denoising = trace::Denoising::off;
    std::vector<TracedView> views;
    for (const Camera& camera : cameras) {
        if (!keepGoing()) return Error{ErrorCode::cancelled, "Stopped.", {}, {}};
        MACULA_TRY_VOID(tracer.setView({.camera = camera, .width = sizePx.x, .height = sizePx.y}));
        MACULA_TRY(const std::vector<trace::GuidePixel> guides, tracer.readGuides());
        const std::vector<float> coverage = pixelCoverage(guides, sizePx);
        std::vector<Found> found(coverage.size());
        for (std::uint32_t rays = 0; rays < kRays; rays += shared::kPrimarySamples) {
            MACULA_TRY_VOID(tracer.setSettings(mine));
            ++mine.seed;
            MACULA_TRY(const std::vector<shared::PrimaryVertex> met,
                       tracer.tracePrimaries(shared::kPrimarySamples, trace::Primaries::alone, keepGoing));
            lookUp(met, camera.positionMm, light, found);
        }
        TracedView view{.camera = camera, .sizePx = sizePx};
        for (std::size_t i = 0; i < found.size(); ++i) view.rgba.push_back(pixelOf(found[i], coverage[i]));
        views.push_back(std::move(view));
        progress.advance();
    }
    return views;
}

}  // namespace macula::hybrid
