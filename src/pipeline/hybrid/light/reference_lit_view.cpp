#include "pipeline/hybrid/light/reference_lit_view.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/camera.h"
#include "base/check.h"
#include "base/parallel.h"

namespace macula::hybrid {

namespace {

// The rays through the centres of a picture's pixels, as the tracer sends them.
struct EyeRays {
    glm::dvec3 right;  // half the width of the picture at distance 1
    glm::dvec3 up;     // half its height
    glm::dvec3 forward;
    glm::ivec2 sizePx;

    glm::dvec3 through(const glm::ivec2& pixel) const {
        const double x = (2.0 * pixel.x + 1.0) / sizePx.x - 1.0;
        const double y = 1.0 - (2.0 * pixel.y + 1.0) / sizePx.y;
        return glm::normalize(forward + x * right + y * up);
    }
};

Result<EyeRays> eyeRays(const Camera& camera, const glm::ivec2& sizePx) {
    MACULA_TRY(const CameraBasis eye, basis(camera));
    const double half = std::tan(glm::radians(camera.verticalFovDeg) / 2.0);
    return EyeRays{.right = eye.right * (half * sizePx.x / sizePx.y),
                   .up = eye.up * half,
                   .forward = eye.forward,
                   .sizePx = sizePx};
}

// The sum of the light of the layers, each weighted by its opacity; unknown layers count as the mean of the
// others. NaN where less than half is known.
glm::vec4 lit(const shared::PixelLayers& layers, const glm::dvec3& eyeMm, const glm::dvec3& direction,
              const LightInSpace& light) {
    const std::array<float, shared::kPixelLayers> middleMm{layers.nearMm.x, layers.nearMm.y, layers.nearMm.z,
                                                           layers.nearMm.w, layers.farMm.x,  layers.farMm.y,
                                                           layers.farMm.z,  layers.farMm.w};
    constexpr double kLayer = 1.0 / shared::kPixelLayers;
    const auto coverage = double(layers.coverage);
    glm::dvec3 sum(0.0);
    double known = 0.0;
    double atMm = double(layers.meanMm);
    for (std::size_t i = 0; i < middleMm.size() && double(i) * kLayer < coverage; ++i) {
        // The last layer may have no middle: then it lies where the one before lies.
        if (middleMm[i] >= 0.0f) atMm = double(middleMm[i]);
        if (atMm < 0.0) break;
        const double hides = std::min(coverage - double(i) * kLayer, kLayer);
        const std::optional<glm::vec3> found = light.at(eyeMm + direction * atMm, direction);
        if (!found) continue;
        sum += hides * glm::dvec3(*found);
        known += hides;
    }
    if (coverage <= 0.0) return glm::vec4(0.0f);
    if (known < 0.5 * coverage) return glm::vec4(std::numeric_limits<float>::quiet_NaN());
    return {glm::vec3(sum * (coverage / known)), layers.coverage};
}

}  // namespace

Result<TracedView> referenceLitView(std::span<const shared::PixelLayers> layers, const Camera& camera,
                                    const glm::ivec2& sizePx, int raysAside, const LightInSpace& light) {
    const glm::ivec2 raysPx = raysAside * sizePx;
    MACULA_CHECK_EQ(layers.size(), std::size_t(raysPx.x) * std::size_t(raysPx.y));
    MACULA_TRY(const EyeRays rays, eyeRays(camera, raysPx));
    TracedView view{.camera = camera, .sizePx = sizePx, .isLit = true};
    view.rgba.resize(std::size_t(sizePx.x) * std::size_t(sizePx.y));
    parallelFor(std::size_t(sizePx.y), [&](std::size_t row) {
        for (int x = 0; x < sizePx.x; ++x) {
            glm::vec4 sum(0.0f);
            for (int n = 0; n < raysAside * raysAside; ++n) {
                const glm::ivec2 ray(raysAside * x + n % raysAside, raysAside * int(row) + n / raysAside);
                sum += lit(layers[std::size_t(ray.y) * std::size_t(raysPx.x) + std::size_t(ray.x)],
                           camera.positionMm, rays.through(ray), light);
            }
            view.rgba[row * std::size_t(sizePx.x) + std::size_t(x)] = sum / float(raysAside * raysAside);
        }
    });
    return view;
}

}  // namespace macula::hybrid
