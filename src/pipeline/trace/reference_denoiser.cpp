#include "pipeline/trace/reference_denoiser.h"

#include <utility>

#include "base/glsl_in_cpp.h"
#include "base/parallel.h"

namespace macula::trace {

namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE

// A class, because the shader functions read their tables as globals.
struct Host : GlslInCpp<double> {
    explicit Host(const shared::DenoisePush& push)
        : denoise{push.imageSize,
                  push.stride,
                  push.last,
                  double(push.pixelAngle),
                  double(push.historySamples),
                  vec2(push.planeHalfSize),
                  vec2(push.gaze),
                  double(push.foveaRadius),
                  double(push.foveaMagnification),
                  double(push.parallelMm),
                  push.doubts} {}

    struct {
        ivec2 imageSize;
        int stride;
        int last;
        double pixelAngle;
        double historySamples;
        vec2 planeHalfSize;
        vec2 gaze;
        double foveaRadius;
        double foveaMagnification;
        double parallelMm;
        int doubts;
    } denoise;
    const DenoiseFilm* film = nullptr;
    const DenoiseGuides* now = nullptr;
    const DenoiseGuides* before = nullptr;
    const DenoiseRecord* memory = nullptr;
    const DenoiseRecord* record = nullptr;
    const DenoiseState* state = nullptr;
    const std::vector<glm::dvec4>* masses = nullptr;

    static std::size_t at(int pixel) { return static_cast<std::size_t>(pixel); }
    vec4 fetchSums(int pixel) const { return film->sums[at(pixel)]; }
    uint fetchCount(int pixel) const { return film->counts[at(pixel)]; }
    double fetchSquares(int pixel) const { return film->squares[at(pixel)]; }
    vec4 fetchSurface(int pixel) const { return now->surfaces[at(pixel)]; }
    vec4 fetchMatter(int pixel) const { return now->matters[at(pixel)]; }
    vec4 fetchMotion(int pixel) const { return now->motions[at(pixel)]; }
    vec4 fetchOldSurface(int pixel) const { return before->surfaces[at(pixel)]; }
    vec4 fetchOldMatter(int pixel) const { return before->matters[at(pixel)]; }
    vec4 fetchOldMean(int pixel) const { return memory->means[at(pixel)]; }
    vec2 fetchOldMoments(int pixel) const { return memory->moments[at(pixel)]; }
    vec4 fetchMean(int pixel) const { return record->means[at(pixel)]; }
    vec2 fetchMoments(int pixel) const { return record->moments[at(pixel)]; }
    vec4 fetchColour(int pixel) const { return state->colours[at(pixel)]; }
    vec4 fetchNoise(int pixel) const { return state->noises[at(pixel)]; }
    vec4 fetchMass(int pixel) const { return (*masses)[at(pixel)]; }

#define float double
#include "lib/denoise.glsl"
#include "lib/denoise_filter.glsl"
#include "lib/denoise_gather.glsl"
#include "lib/denoise_prepare.glsl"
#include "lib/denoise_specks.glsl"
#include "lib/denoise_variance.glsl"
#include "lib/fovea.glsl"
#include "lib/picture.glsl"
#include "lib/variance.glsl"
#undef float
};

#undef OUT
#undef INOUT
#undef PRECISE

// Calls body(host, pixel, index) for each pixel.
template <class Body>
void forEachPixel(const Host& prototype, const Body& body) {
    parallelFor(static_cast<std::size_t>(prototype.denoise.imageSize.y), [&](std::size_t row) {
        Host host = prototype;
        for (int x = 0; x < host.denoise.imageSize.x; ++x) {
            const glm::ivec2 pixel(x, int(row));
            body(host, pixel, Host::at(host.indexOf(pixel)));
        }
    });
}

}  // namespace

DenoiseRecord denoiseGather(const shared::DenoisePush& push, const DenoiseFilm& film,
                            const DenoiseGuides& now, const DenoiseGuides& before,
                            const DenoiseRecord& memory) {
    Host prototype(push);
    prototype.film = &film;
    prototype.now = &now;
    prototype.before = &before;
    prototype.memory = &memory;
    DenoiseRecord record{std::vector<glm::dvec4>(film.sums.size()),
                         std::vector<glm::dvec2>(film.sums.size())};
    forEachPixel(prototype, [&](Host& host, const glm::ivec2& pixel, std::size_t index) {
        const auto gathered = host.gatherPixel(pixel);
        record.means[index] = gathered.mean;
        record.moments[index] = {gathered.square, gathered.samples};
    });
    return record;
}

DenoiseState denoisePrepare(const shared::DenoisePush& push, const DenoiseRecord& record,
                            const DenoiseGuides& now, std::vector<glm::dvec4>& masses) {
    Host prototype(push);
    prototype.record = &record;
    prototype.now = &now;
    masses.resize(record.means.size());
    DenoiseState state{record.means, std::vector<glm::dvec4>(record.means.size())};
    forEachPixel(prototype, [&](Host& host, const glm::ivec2& pixel, std::size_t index) {
        const auto prepared = host.preparePixel(pixel);
        masses[index] = prepared.mass;
        state.noises[index] = prepared.noise;
    });
    return state;
}

DenoiseState denoiseFilter(const shared::DenoisePush& push, const DenoiseState& state,
                           const DenoiseGuides& now, const std::vector<glm::dvec4>& masses) {
    Host prototype(push);
    prototype.state = &state;
    prototype.now = &now;
    prototype.masses = &masses;
    DenoiseState next = state;
    forEachPixel(prototype, [&](Host& host, const glm::ivec2& pixel, std::size_t index) {
        const auto filtered = host.filterPixel(pixel);
        next.colours[index] = filtered.colour;
        next.noises[index].x = filtered.variance.x;
        next.noises[index].y = filtered.variance.y;
    });
    return next;
}

namespace {

std::vector<glm::dvec4> withoutSpecks(Host prototype, const DenoiseState& state, const DenoiseGuides& now,
                                      const std::vector<glm::dvec4>& masses) {
    prototype.state = &state;
    prototype.now = &now;
    prototype.masses = &masses;
    std::vector<glm::dvec4> shown(state.colours.size());
    forEachPixel(prototype, [&](Host& host, const glm::ivec2& pixel, std::size_t index) {
        shown[index] = host.withoutSpeck(pixel);
    });
    return shown;
}

}  // namespace

std::vector<glm::dvec4> denoiseSpecksFirst(const shared::DenoisePush& push, const DenoiseRecord& record,
                                           const DenoiseState& state, const DenoiseGuides& now,
                                           const std::vector<glm::dvec4>& masses) {
    Host host(push);
    host.denoise.stride = 0;
    host.record = &record;
    return withoutSpecks(std::move(host), state, now, masses);
}

std::vector<glm::dvec4> denoiseSpecks(const shared::DenoisePush& push, const DenoiseState& state,
                                      const DenoiseGuides& now, const std::vector<glm::dvec4>& masses) {
    return withoutSpecks(Host(push), state, now, masses);
}

std::vector<double> denoiseVariances(const shared::DenoisePush& push, const DenoiseRecord& record,
                                     const DenoiseState& state, const DenoiseGuides& now,
                                     const std::vector<glm::dvec4>& masses) {
    Host prototype(push);
    prototype.record = &record;
    prototype.state = &state;
    prototype.now = &now;
    prototype.masses = &masses;
    std::vector<double> variances(state.colours.size());
    forEachPixel(prototype, [&](Host& host, const glm::ivec2& pixel, std::size_t index) {
        variances[index] = host.varianceOfFiltered(pixel);
    });
    return variances;
}

}  // namespace macula::trace
