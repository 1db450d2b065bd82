#include "pipeline/volume/coat.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/glsl_in_cpp.h"

namespace macula {

namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PI 3.14159265358979323846
struct Shader : GlslInCpp<double> {
    static constexpr int kCoatSteps = shared::kCoatSteps;
    struct {
        double anisotropy = 0.0;
        double surfaceAlpha = 1.0;
        double surfaceReflectance = 0.0;
        std::array<double, shared::kCoatPlaces> coatAlbedo{};
        double coatMean = 0.0;
    } params;
#define float double
#include "lib/phase.glsl"
#include "lib/scattering.glsl"
#undef float
};
#undef OUT
#undef INOUT
#undef PI
#undef GRAZING

// The mean reflectance of visible facets, reduced by the shadowing of other facets.
double albedoAt(Shader& shader, double cosine) {
    constexpr int kSide = 64;
    const glm::dvec3 from(-std::sqrt(1.0 - cosine * cosine), 0.0, -cosine);
    const glm::dvec3 x(1.0, 0.0, 0.0);
    const glm::dvec3 y(0.0, 1.0, 0.0);
    const glm::dvec3 normal(0.0, 0.0, 1.0);
    const double hidden = shader.smithLambda(cosine);
    double sum = 0.0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const glm::dvec2 u((i + 0.5) / kSide, (j + 0.5) / kSide);
            const glm::dvec3 facet = shader.facetSeen(normal, x, y, from, u);
            const glm::dvec3 to = from - facet * (2.0 * glm::dot(from, facet));
            if (to.z <= 0.0) continue;
            sum += shader.facetReflectance(glm::dot(facet, to)) * (1.0 + hidden) /
                   (1.0 + hidden + shader.smithLambda(to.z));
        }
    }
    return std::min(sum / (kSide * kSide), 1.0);
}

Coat computed(const Surface& surface) {
    constexpr double kLeastCosine = 1e-4;
    Shader shader;
    shader.params.surfaceAlpha = alphaOf(surface);
    shader.params.surfaceReflectance = surface.reflectance;
    Coat coat;
    for (std::size_t i = 0; i < coat.albedo.size(); ++i) {
        const double root = double(i) / shared::kCoatSteps;
        coat.albedo[i] = albedoAt(shader, std::max(root * root, kLeastCosine));
    }
    shader.params.coatAlbedo = coat.albedo;
    constexpr int kCosines = 512;
    for (int i = 0; i < kCosines; ++i) {
        const double cosine = (i + 0.5) / kCosines;
        coat.mean += shader.coatAlbedo(cosine) * 2.0 * cosine / kCosines;
    }
    return coat;
}

}  // namespace

// Cached, because dragging a curve does not change its coat.
Coat coatOf(const Surface& surface) {
    thread_local std::pair<glm::dvec2, Coat> last{glm::dvec2(-1.0), {}};
    const glm::dvec2 of(surface.roughness, surface.reflectance);
    if (last.first != of) last = {of, computed(surface)};
    return last.second;
}

}  // namespace macula
